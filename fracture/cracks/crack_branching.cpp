// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/crack_branching.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "fracture/cracks/tip_stress.h"

namespace sherd {
namespace {

/// Time constant of the mean release (GrowingTip::release), given by the number of edges that a tip passes in
/// this time at its speed limit. A mean is needed since stress varies by a factor of four while an edge
/// opens.
constexpr double edges_of_mean = 3;
/// Time constant of the mean release of a tip that is driven mostly by residual stress, given by the
/// distance, in thicknesses, that the tip advances in this time at its speed limit. Residual stress varies
/// less while an edge opens, and relaxes around the path of a tip in this time. Two branches that residual
/// stress drives may branch again once they are this distance apart.
constexpr double thicknesses_of_mean = 0.5;
/// Mean of G / G_c above which a tip branches: twice the mean of a tip that just keeps propagating. That mean
/// is 1 if the load follows from energy. It is 0.7 if the load follows from stress, which falls when an edge
/// opens and rises until the next edge opens.
constexpr double exceeds_by_energy = 2, exceeds_by_stress = 1.4;
/// Share of the speed limit above which a tip counts as running at its limit: the speed fluctuates, since
/// edges differ in length and time advances in steps.
constexpr double share_of_limit = 0.8;
/// Angle between the crack's direction and each of its two branches, rad.
constexpr double branch_angle = 25 * std::numbers::pi / 180;
/// Distances between two branches, in edge lengths: below coupled_edges they propagate together, and below
/// edges_between they do not branch again, since a tip slows down where it branches, and its load is too
/// large until it runs again.
constexpr double coupled_edges = 3, edges_between = 8;

bool is_driven_by_residual(const TipLoad& load) {
    return load.residual > 0.5;
}

/// The other branch of a tip, if its distance at rest is less than `apart` (m); else null.
const GrowingTip* branch_within(double apart, const BreakableShell& shell, const GrowingTip& tip,
                                std::span<const GrowingTip> all) {
    if (tip.other_branch < 0) return nullptr;
    const auto other_branch = std::ranges::find(all, tip.other_branch, &GrowingTip::number);
    if (other_branch == all.end()) return nullptr;
    const Positions& rest = shell.mechanics().rest;
    const double gap = (rest.col(other_branch->vertex) - rest.col(tip.vertex)).norm();
    return gap < apart ? &*other_branch : nullptr;
}

}  // namespace

void update_mean_release(const BreakableShell& shell, GrowingTip& tip, const TipLoad& load,
                         double intensity_ratio, double waited) {
    double way = edges_of_mean * edge_length_ahead(shell, tip), counts = 1;
    if (is_driven_by_residual(load)) way = thicknesses_of_mean * shell.mechanics().thickness[tip.vertex];
    if (!load.by_energy) counts -= load.residual * (1 - exceeds_by_stress / exceeds_by_energy);
    const double window = way / shell.toughness_at(tip.vertex).speed_limit,
                 share = waited < window ? waited / window : 1;
    tip.release += share * (intensity_ratio * intensity_ratio * counts - tip.release);
}

bool branches(const BreakableShell& shell, const GrowingTip& tip, const TipLoad& load,
              std::span<const GrowingTip> all, double time) {
    const double apart = is_driven_by_residual(load)
                             ? thicknesses_of_mean * shell.mechanics().thickness[tip.vertex]
                             : edges_between * edge_length_ahead(shell, tip);
    return tip.stride > 0 && tip.release > (load.by_energy ? exceeds_by_energy : exceeds_by_stress) &&
           tip.speed(time) > share_of_limit * shell.toughness_at(tip.vertex).speed_limit &&
           branch_within(apart, shell, tip, all) == nullptr;
}

std::array<Vector3d, 2> branch_directions(const BreakableShell& shell, const GrowingTip& tip,
                                          const Vector3d& direction) {
    const Vector3d normal = rest_normal_at(shell, Vertex(tip.vertex));
    return {Eigen::AngleAxisd(branch_angle, normal) * direction,
            Eigen::AngleAxisd(-branch_angle, normal) * direction};
}

const GrowingTip* near_branch(const BreakableShell& shell, const GrowingTip& tip,
                              std::span<const GrowingTip> all) {
    return branch_within(coupled_edges * edge_length_ahead(shell, tip), shell, tip, all);
}

}  // namespace sherd
