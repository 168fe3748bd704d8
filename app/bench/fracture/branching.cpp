// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/bench/fracture/grown_crack.h"

namespace sherd {
namespace {

constexpr double behind = 5e-3;  // m, distance along x from the first fork at which its arms are measured

struct CrackEdge {
    Vector2d left, right;  ///< m
};

/// The edges that failed in the steps of a run, without the crack of the start.
std::vector<CrackEdge> crack_edges(const FractureHistory& run) {
    std::vector<CrackEdge> edges;
    for (const EdgeFailure& failure : run.events.failures) {
        if (failure.step == 0) continue;
        const Vector2d a = run.rest.col(failure.vertices[0]).head<2>(),
                       b = run.rest.col(failure.vertices[1]).head<2>();
        edges.push_back(a.x() < b.x() ? CrackEdge{a, b} : CrackEdge{b, a});
    }
    return edges;
}

/// The leftmost point from which more than one edge goes to the right; none if there is no such point.
std::optional<Vector2d> first_fork(const std::vector<CrackEdge>& edges) {
    std::map<std::array<double, 2>, int> leave;
    for (const CrackEdge& edge : edges) ++leave[{edge.left.x(), edge.left.y()}];
    for (const auto& [point, count] : leave)
        if (count > 1) return Vector2d(point[0], point[1]);
    return std::nullopt;
}

/// Heights y, m, at which the line across the plate at `x` (m) meets the cracks, ascending.
std::vector<double> heights_at(double x, const std::vector<CrackEdge>& edges) {
    std::vector<double> heights;
    for (const auto& [left, right] : edges)
        if (left.x() <= x && x < right.x())
            heights.push_back(left.y() + (x - left.x()) / (right.x() - left.x()) * (right - left).y());
    std::ranges::sort(heights);
    return heights;
}

std::vector<double> measure_fork(const FractureHistory& run) {
    const std::vector<CrackEdge> edges = crack_edges(run);
    const std::optional<Vector2d> fork = first_fork(edges);
    if (!fork) return {};
    double length = 0;
    for (const auto& [left, right] : edges)
        if (left.x() < fork->x()) length += (right - left).norm();
    const Vector2d tip = FirstCrack(run.scene).to;
    const std::vector<double> arms = heights_at(fork->x() + behind, edges);
    if (arms.size() < 2) return {};
    const double rise = arms.back() - fork->y(), fall = fork->y() - arms.front();
    return {length / (*fork - tip).norm(), static_cast<double>(arms.size()), (rise - fall) / (rise + fall),
            std::atan2(arms.back() - arms.front(), 2 * behind) * 180 / std::numbers::pi};
}

}  // namespace

FractureCase branching() {
    return {.name = "branching",
            .scene = "experiments/branching",
            .variant = "",
            .source = "straight, then to both sides alike (Bobaru and Zhang 2015)",
            .unit = 0.04,
            .in_units = "W",
            .edges = {0.0014, 0.001, 0.0007},
            .numbers = {{"path until it branches / straight", 1, 0.02},
                        {"arms", 2, 0},
                        {"asymmetry", 0, 0.2},
                        {"half angle (degrees)", 25, 5}},
            .measure = measure_fork};
}

}  // namespace sherd
