// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/crack_branching.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "fracture/cracks/tip_stress.h"

namespace sherd {
namespace {

/// Time constant of the mean release, in edges at the speed limit: stress varies by a factor of four while an
/// edge opens.
constexpr double edges_of_mean = 3;
/// Time constant of the mean release that is mostly residual stress, in thicknesses at the speed limit:
/// residual stress does not vary so, and relaxes around the path of a tip in this time. Branches driven by it
/// may branch again once they are this far apart.
constexpr double thicknesses_of_mean = 0.5;
/// Mean of G over G_c above which a tip branches: twice what it needs. By stress this is twice 0.7, the mean
/// of a tip that just keeps propagating: stress falls when an edge opens, and rises until the next one does.
constexpr double exceeds_by_energy = 2, exceeds_by_stress = 1.4;
/// Share of the speed limit above which a tip counts as running at it: its speed fluctuates, since edges
/// differ and time advances in steps.
constexpr double share_of_limit = 0.8;
/// Angle between either branch and the crack's direction, rad.
constexpr double branch_angle = 25 * std::numbers::pi / 180;
/// Distances between branches, in edges: below the first they propagate together, below the second they do
/// not branch again. A tip slows down where it branches, and its load is too large until it runs again.
constexpr double coupled_edges = 3, edges_between = 8;

bool is_driven_by_residual(const TipLoad& load) {
    return load.residual > 0.5;
}

/// The other branch of a tip if it is nearer than `apart` (m, at rest); else null.
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
