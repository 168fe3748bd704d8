// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/near_pairs.h"

#include <algorithm>
#include <utility>

#include "core/contact/geometry/continuous_collision.h"

namespace sherd {
namespace {

/// Lengths, in half thicknesses of the thinnest sheet: the margin by which vertices may depart from the
/// motion before candidates are searched again, the margin of pairs_nearby(), and the length of the motion
/// that a search covers.
constexpr double margin_of_candidates = 0.5, nearby = 0.1, ahead = 12;
/// Larger lengths for triangles that are much wider than the thickness: large neighbourhoods cost little
/// there, and the search directions of a minimiser change. The margin grows to margin_of_motion times the
/// length of the motion, up to margin_of_width mean widths of triangles (mean_width()); the length of the
/// motion that a search covers grows to ahead_of_width mean widths.
constexpr double margin_of_motion = 2, margin_of_width = 0.2, ahead_of_width = 0.6;
/// Largest multiple of the given motion that a search covers, unless the motion is so short that a larger
/// multiple is still shorter than the margin.
constexpr double most_steps = 10;
/// Length, in mean widths of triangles, and largest number of the parts in which a motion is tested. The
/// number of pairs within reach of a part grows with the square of the part's length: a diverging search
/// direction of a minimiser would take all memory.
constexpr double widths_of_part = 2, most_parts = 64;

/// Clearance that safe_fraction() of a pair leaves: a share of the range for barriers; a share of the
/// activation distance, the smaller one, for springs and where pairs need only not pass through each other.
constexpr double clearance_of_barriers = 0.5, clearance_of_passing = 1e-3;
/// Smallest gap, as a share of a barrier's range, at which implicit steps with barriers may follow explicit
/// steps with springs.
constexpr double barrier_range_left = 0.02;

double clearance(const ContactPair& pair) {
    return (pair.spring ? clearance_of_passing : clearance_of_barriers) * pair.barrier().range;
}

/// Mean, over all triangles, of the height above the longest edge, m: nearly the length of an edge for
/// equilateral triangles, the width for needle-shaped ones.
double mean_width(const ContactSurface& surface, const Positions& x) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles()) {
        const Vector3d ab = x.col(b) - x.col(a), ac = x.col(c) - x.col(a), bc = x.col(c) - x.col(b);
        const double longest = std::max({ab.squaredNorm(), ac.squaredNorm(), bc.squaredNorm()});
        if (longest > 0) sum += ab.cross(ac).norm() / std::sqrt(longest);
    }
    return sum / static_cast<double>(std::max<std::size_t>(surface.triangles().size(), 1));
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
    found.follow(change, before, of, trees);
    last.resize(3, 0);
}

void NearPairs::find(const Positions& x, const Positions& motion) const {
    const double unit = thinnest_half(of), width = mean_width(of, x);
    const Positions way = Neighbourhood(x, motion, 0, of.collider_vertices()).motion;
    const double length = way.colwise().norm().maxCoeff();
    const double margin =
        std::max(margin_of_candidates * unit, std::min(margin_of_motion * length, margin_of_width * width));
    const double most = length > 0 ? std::max(most_steps, margin / length) : most_steps;
    const double steps = std::clamp(std::max(ahead * unit, ahead_of_width * width) / length, 1.0, most);
    found =
        ContactCandidates(of, Neighbourhood(x, steps * way, margin, of.collider_vertices()), trees, threads);
}

Neighbourhood NearPairs::surroundings(const Positions& x, const Positions& motion) const {
    return {x, motion, nearby * thinnest_half(of), of.collider_vertices()};
}

const ContactCandidates& NearPairs::candidates(const Positions& x, const Positions& motion) const {
    const Neighbourhood& known = found.neighbourhood();
    if (!known.contains(x) || !known.contains(x + motion)) find(x, motion);
    return found;
}

const ContactCandidates& NearPairs::candidates(const Positions& x) const {
    if (!found.neighbourhood().contains(x)) find(x, Positions::Zero(3, x.cols()));
    return found;
}

const std::vector<ContactPair>& NearPairs::active_pairs(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return active;
    candidates(x);
    active = found.active(of, x);
    for (ContactPair& pair : active) pair.second_spring = spring_of_pairs;
    last = x;
    return active;
}

double NearPairs::parts(const Positions& x, const Positions& motion) const {
    const Positions way = Neighbourhood(x, motion, 0, of.collider_vertices()).motion;
    const double length = way.cols() > 0 ? way.colwise().norm().maxCoeff() : 0;
    const double longest = widths_of_part * mean_width(of, x);
    return longest > 0 && length > longest ? std::ceil(length / longest) : 1;
}

double NearPairs::free_fraction(const Positions& x, const Positions& motion, Gap gap) const {
    const double parts = this->parts(x, motion);
    if (parts == 1) return free_fraction_of_part(x, motion, gap);
    const Positions part = motion / parts;
    for (double before = 0; before < std::min(parts, most_parts); ++before)
        if (const double fraction = free_fraction_of_part(x + before * part, part, gap); fraction < 1)
            return (before + fraction) / parts;
    return std::min(1.0, most_parts / parts);
}

double NearPairs::free_fraction_of_part(const Positions& x, const Positions& motion, Gap gap) const {
    const ContactCandidates& all = candidates(x, motion);
    const double round_off = 4 * all.neighbourhood().round_off;
    struct Room {
        double minimum, clearance;
    };
    const auto room_of = [&](const ContactPair& pair) {
        return gap == Gap::minimum ? Room{pair.minimum(), clearance(pair)}
                                   : Room{0, clearance_of_passing * pair.activation_distance};
    };
    const auto may_meet = [&](const ContactPair& pair, double least) {
        const double way = approach(pair.kind, columns(motion, pair.vertices)) + round_off;
        const auto [minimum, clearance] = room_of(pair);
        return !surely_free(least - round_off, way, minimum, clearance);
    };
    double fraction = 1;
    for (const ContactPair& pair : all.near(x, motion, 1, 0, may_meet)) {
        const PairPositions from = columns(x, pair.vertices);
        const PairPositions way = fraction * columns(motion, pair.vertices);
        const auto [minimum, clearance] = room_of(pair);
        if (distance_of_boxes(pair.kind, from) < minimum + clearance + approach(pair.kind, way))
            fraction *= sherd::safe_fraction(pair.kind, from, way, minimum, clearance);
    }
    return fraction;
}

bool NearPairs::allow_barriers(const Positions& x) const {
    return std::ranges::none_of(active_pairs(x), [&](const ContactPair& pair) {
        const double minimum = of.minimum_of_barrier(pair);
        return within(minimum + barrier_range_left * (pair.activation_distance - minimum), pair,
                      columns(x, pair.vertices));
    });
}

std::vector<ContactPair> NearPairs::pairs_nearby(const Positions& x) const {
    const Neighbourhood near = surroundings(x, Positions::Zero(3, x.cols()));
    return ContactCandidates(of, near, trees, threads).pick(of, near);
}

void NearPairs::each_nearby(const Positions& x, const Positions& motion,
                            const std::function<void(const ContactPair&)>& visit_pair) const {
    const double parts = this->parts(x, motion);
    if (parts > most_parts) return;
    const Positions part = motion / parts;
    for (double before = 0; before < parts; ++before) {
        const Neighbourhood near = surroundings(x + before * part, part);
        if (!found.neighbourhood().contains(near)) find(x + before * part, part);
        std::ranges::for_each(found.pick(of, near), visit_pair);
    }
}

std::vector<ContactPair> NearPairs::pairs_within_reach(const Positions& x, const Positions& motion) const {
    const auto may_reach = [&](const ContactPair& pair, double) {
        const double way = approach(pair.kind, columns(motion, pair.vertices));
        return within(pair.activation_distance + way, pair, columns(x, pair.vertices));
    };
    std::vector<ContactPair> reached = candidates(x, motion).near(x, motion, 1, 0, may_reach);
    for (ContactPair& pair : reached) {
        of.stiffen(pair);
        pair.second_spring = spring_of_pairs;
    }
    return reached;
}

void NearPairs::set_second_spring(SecondSpring of_springs) {
    spring_of_pairs = of_springs;
    last.resize(3, 0);
}

double NearPairs::least_share(const Positions& x) const {
    double least = 1;
    for (const ContactPair& pair : active_pairs(x))
        least = std::min(least, distance(pair, columns(x, pair.vertices)) / pair.activation_distance);
    return least;
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
    constexpr double nearness = ContactCandidates::nearness;
    const auto is_near = [&](const ContactPair& pair, double) {
        return within(nearness * pair.activation_distance, pair, columns(x, pair.vertices));
    };
    std::ranges::for_each(candidates(x).near(x, Positions(3, 0), nearness, 0, is_near), add);
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
