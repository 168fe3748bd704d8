// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/near_pairs.h"

#include <algorithm>
#include <utility>

#include "core/contact/geometry/continuous_collision.h"

namespace sherd {
namespace {

/// A lower bound of the pair's distance, m: that of the elements' bounding boxes.
double distance_of_boxes(PairKind kind, const PairPositions& x) {
    const int first = vertices_of_first(kind);
    const auto one = x.leftCols(first), other = x.rightCols(4 - first);
    const Vector3d above = one.rowwise().minCoeff() - other.rowwise().maxCoeff();
    const Vector3d below = other.rowwise().minCoeff() - one.rowwise().maxCoeff();
    return std::max(above.maxCoeff(), below.maxCoeff());
}

/// Whether the pair is closer than `limit`, m.
bool within(double limit, const ContactPair& pair, const Positions& x) {
    const PairPositions local = columns(x, pair.vertices);
    return distance_of_boxes(pair.kind, local) < limit && distance(pair, local) < limit;
}

/// Margins by which vertices may depart from the motion before candidates are searched again, in half
/// thicknesses of the thinnest sheet: over many steps, and in one step.
constexpr double margin_of_all = 0.5, margin_of_step = 0.1;

/// Share of the range that a motion may leave of it. Springs are asked only whether elements pass each other.
constexpr double clearance_of_springs = 1e-3;

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

}  // namespace

void NearPairs::surface_changed(const ShellChange& change, ContactSurface surface) {
    const ContactSurface before = std::exchange(of, std::move(surface));
    found.follow(change, before, of, colliders);
    near = {};
    last.resize(3, 0);
}

const std::vector<ContactPair>& NearPairs::candidates(const Positions& x, const Positions& motion) const {
    if (near.contains(x) && near.contains(x + motion)) return pairs;
    const double unit = thinnest_half(of);
    near = Neighbourhood(x, motion, margin_of_step * unit, of.collider_vertices());
    if (!found.neighbourhood().contains(near))
        found = ContactCandidates(of,
                                  Neighbourhood(x, lookahead(near.motion, unit) * motion,
                                                margin_of_all * unit, of.collider_vertices()),
                                  colliders);
    pairs = found.pick(of, near);
    return pairs;
}

const std::vector<ContactPair>& NearPairs::active_pairs(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return active;
    active.clear();
    for (const ContactPair& pair : candidates(x, Positions::Zero(3, x.cols())))
        if (within(pair.activation_distance, pair, x)) active.push_back(pair);
    last = x;
    return active;
}

double NearPairs::safe_fraction(const Positions& x, const Positions& motion) const {
    double fraction = 1;
    for (const ContactPair& pair : candidates(x, motion)) {
        const PairPositions from = columns(x, pair.vertices);
        const PairPositions way = fraction * columns(motion, pair.vertices);
        const double clearance = (pair.spring ? clearance_of_springs : 0.5) * pair.barrier().range;
        const double kept = pair.minimum() + clearance;
        if (distance_of_boxes(pair.kind, from) < kept + approach(pair.kind, way))
            fraction *= sherd::safe_fraction(pair.kind, from, way, pair.minimum(), clearance);
    }
    return fraction;
}

std::vector<ContactPair> NearPairs::pairs_within_reach(const Positions& x, const Positions& motion) const {
    std::vector<ContactPair> reached;
    for (const ContactPair& pair : candidates(x, motion)) {
        const double way = approach(pair.kind, columns(motion, pair.vertices));
        if (within(pair.activation_distance + way, pair, x)) reached.push_back(pair);
    }
    return reached;
}

void NearPairs::add_contacts(const Positions& x, bool ahead,
                             std::vector<std::pair<Index, Index>>& blocks) const {
    for (const ContactPair& pair : ahead ? candidates(x, Positions::Zero(3, x.cols())) : active_pairs(x))
        if (!ahead || within(ContactCandidates::nearness * pair.activation_distance, pair, x))
            add_pairs(blocks, numbered_from(pair.vertices, of.collider_vertices()));
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
