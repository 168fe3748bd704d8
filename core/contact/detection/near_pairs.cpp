// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/near_pairs.h"

#include <algorithm>
#include <utility>

#include "core/contact/geometry/continuous_collision.h"

namespace sherd {
namespace {

/// Margin by which vertices may depart from the motion before candidates are searched again, and by how much
/// farther than `nearness` says pairs count as near, in half thicknesses of the thinnest sheet.
constexpr double margin_of_candidates = 0.5, nearby = 0.2;

/// Share of the range that a motion may leave of it. Springs are asked only whether elements pass each other.
constexpr double clearance_of_springs = 1e-3;

double clearance(const ContactPair& pair) {
    return (pair.spring ? clearance_of_springs : 0.5) * pair.barrier().range;
}

/// For how many steps like this one to search candidates: fewer if they lead far. motion: less its mean, m.
double lookahead(const Positions& motion, double unit) {
    return std::clamp(12 * unit / motion.colwise().norm().maxCoeff(), 1.0, 10.0);
}

double thinnest_half(const ContactSurface& surface) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (Index v = surface.collider_vertices(); v < surface.vertices(); ++v)
        thinnest = std::min(thinnest, surface.half_thickness(v));
    return thinnest;
}

/// How much farther apart than when they are active elements may be that count as near, m.
double reserve_of_near(const ContactSurface& surface) {
    double thickest = 0;
    for (Index v = surface.collider_vertices(); v < surface.vertices(); ++v)
        thickest = std::max(thickest, 2 * surface.largest_half_thickness(v));
    return (ContactCandidates::nearness - 1) * thickest;
}

}  // namespace

void NearPairs::surface_changed(const ShellChange& change, ContactSurface surface) {
    const ContactSurface before = std::exchange(of, std::move(surface));
    found.follow(change, before, of, colliders);
    last.resize(3, 0);
}

void NearPairs::find(const Positions& x, const Positions& motion) const {
    const auto reaches = [&](const Positions& to) { return found.neighbourhood().contains(to); };
    if (reaches(x) && (motion.cols() == 0 || reaches(x + motion))) return;
    const double unit = thinnest_half(of), margin = margin_of_candidates * unit;
    const Neighbourhood way(x, motion.cols() == 0 ? Positions::Zero(3, x.cols()) : motion, margin,
                            of.collider_vertices());
    found = ContactCandidates(
        of, Neighbourhood(x, lookahead(way.motion, unit) * way.motion, margin, of.collider_vertices()),
        colliders);
}

const std::vector<ContactPair>& NearPairs::active_pairs(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return active;
    find(x, {});
    found.find_active(of, x, active);
    last = x;
    return active;
}

double NearPairs::safe_fraction(const Positions& x, const Positions& motion) const {
    find(x, motion);
    std::vector<ContactPair> close;
    const double round_off = 4 * found.neighbourhood().round_off;
    found.visit_near(x, motion, 0, [&](const ContactPair& pair, double least) {
        const double way = approach(pair.kind, columns(motion, pair.vertices));
        if (least < pair.minimum() + clearance(pair) + way + round_off) close.push_back(pair);
    });
    std::ranges::sort(close, before);
    double fraction = 1;
    for (const ContactPair& pair : close) {
        const PairPositions from = columns(x, pair.vertices);
        const PairPositions way = fraction * columns(motion, pair.vertices);
        const double kept = pair.minimum() + clearance(pair);
        if (distance_of_boxes(pair.kind, from) < kept + approach(pair.kind, way))
            fraction *= sherd::safe_fraction(pair.kind, from, way, pair.minimum(), clearance(pair));
    }
    return fraction;
}

std::vector<ContactPair> NearPairs::pairs_within_reach(const Positions& x, const Positions& motion) const {
    find(x, motion);
    std::vector<ContactPair> reached;
    found.visit_near(x, motion, 0, [&](const ContactPair& pair, double) {
        const double way = approach(pair.kind, columns(motion, pair.vertices));
        if (within(pair.activation_distance + way, pair, columns(x, pair.vertices))) reached.push_back(pair);
    });
    std::ranges::sort(reached, before);
    for (ContactPair& pair : reached) of.stiffen(pair);
    return reached;
}

std::vector<ContactPair> NearPairs::pairs_nearby(const Positions& x, const Positions& motion) const {
    find(x, motion);
    std::vector<ContactPair> near;
    const double wider = nearby * thinnest_half(of);
    const double reserve = reserve_of_near(of) + wider;
    found.visit_near(x, motion, reserve, [&](const ContactPair& pair, double) {
        const double limit = ContactCandidates::nearness * pair.activation_distance + wider;
        const PairPositions from = columns(x, pair.vertices), way = columns(motion, pair.vertices);
        if (!within(limit + approach(pair.kind, way), pair, from)) return;
        const Vector3d direction = (from * closest_points(pair.kind, from).weights).normalized();
        if (separation(pair.kind, from, direction) < limit ||
            separation(pair.kind, from + way, direction) < limit)
            near.push_back(pair);
    });
    std::ranges::sort(near, before);
    return near;
}

void NearPairs::add_contacts(const Positions& x, bool ahead,
                             std::vector<std::pair<Index, Index>>& blocks) const {
    const auto add = [&](const ContactPair& pair) {
        add_pairs(blocks, numbered_from(pair.vertices, of.collider_vertices()));
    };
    if (!ahead) {
        std::ranges::for_each(active_pairs(x), add);
        return;
    }
    find(x, {});
    found.visit_near(x, {}, reserve_of_near(of), [&](const ContactPair& pair, double) {
        if (within(ContactCandidates::nearness * pair.activation_distance, pair, columns(x, pair.vertices)))
            add(pair);
    });
}

void NearPairs::add_touched(const Positions& x, std::set<Index>& vertices,
                            std::set<const ColliderSurface*>& touched) const {
    if (of.collider_vertices() == 0) return;
    for (const ContactPair& pair : active_pairs(x)) {
        const ContactCollider* collider = of.collider_of(pair.kind, pair.vertices);
        if (!collider) continue;
        touched.insert(collider->surface);
        for (const Index vertex : pair.vertices)
            if (!of.of_collider(vertex)) vertices.insert(vertex - of.collider_vertices());
    }
}

}  // namespace sherd
