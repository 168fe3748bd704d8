// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/opening_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {
namespace {

constexpr double longest = 12;  // age of an edge over the time of its opening, from which no force is left
constexpr double least_force = 1e-10;  // share of the largest force; smaller forces are round-off

/// The vertices on which forces, [3, V] N, act, ascending.
std::vector<Index> vertices_under(const Positions& forces) {
    const VectorXd sizes = forces.colwise().norm();
    const double least = least_force * sizes.maxCoeff();
    std::vector<Index> vertices;
    for (Index v = 0; v < static_cast<Index>(sizes.size()); ++v)
        if (sizes[v] > least) vertices.push_back(v);
    return vertices;
}

}  // namespace

void OpeningEdges::CohesiveEdge::add(double factor, Positions& sum) const {
    for (std::size_t i = 0; i < vertices.size(); ++i)
        sum.col(vertices[i]) += factor * forces.col(static_cast<Index>(i));
}

void OpeningEdges::CohesiveEdge::cancel(Positions& others) {
    const double size = share * forces.squaredNorm();
    if (size == 0) return;
    const double opposed = std::clamp(-forces.cwiseProduct(columns_of(others)).sum() / size, 0.0, 1.0);
    add(opposed * share, others);
    forces *= 1 - opposed;
    needed *= 1 - opposed;
    taken *= 1 - opposed;
}

void OpeningEdges::CohesiveEdge::fade_until(double end) {
    share = end - since < lasts ? 1 - (end - since) / lasts : 0;
}

void OpeningEdges::open(const Opening& edge, Positions forces, const Positions& x, double released) {
    if (fading == Fading::by_work) {
        for (CohesiveEdge& one : all) one.cancel(forces);
        std::erase_if(all, [](const CohesiveEdge& one) { return one.needed == 0; });
    }
    if (!(edge.energy > released)) return;
    const std::vector<Index> vertices = vertices_under(forces);
    all.push_back({edge.edge, vertices, forces(Eigen::all, vertices), edge.energy - released, edge.time,
                   x(Eigen::all, vertices), start});
    if (fading == Fading::by_time) all.back().fade_until(end);
}

double OpeningEdges::cohesive_share(Index edge) const {
    const auto found = std::ranges::find(all, edge, &CohesiveEdge::edge);
    if (found == all.end()) return 0;
    return fading == Fading::by_time ? found->share : std::sqrt(1 - found->taken / found->needed);
}

void OpeningEdges::add_forces(Positions& sum) const {
    for (const CohesiveEdge& one : all) one.add(one.share, sum);
}

void OpeningEdges::fade(const Positions& moved, double length) {
    for (CohesiveEdge& one : all) {
        const double against = one.against(moved);
        one.age += length;
        const double reached = one.taken + one.share * std::max(0.0, against);
        const double before = one.share, left = std::sqrt(std::max(0.0, 1 - reached / one.needed));
        // Where the edge closes, the remaining forces would drive this motion: they are zero until the edge
        // opens again.
        one.share = against < 0 ? 0 : std::min(left, std::max(0.0, 1 - one.age / (longest * one.lasts)));
        one.taken = left > 0 ? one.taken + std::max(0.0, 0.5 * (before + one.share) * against) : one.needed;
    }
    std::erase_if(all, [](const CohesiveEdge& one) {
        return one.taken >= one.needed || one.age >= longest * one.lasts;
    });
}

void OpeningEdges::begin_step(const StepContext& step, const Positions& x) {
    start = step.begin;
    end = step.inertia > 0 ? step.end() : std::numeric_limits<double>::infinity();
    all = finished;
    is_solved = false;
    settled = 0;
    shell_changed(x);
    for (CohesiveEdge& one : all) one.fade_until(end);
}

void OpeningEdges::settle() {
    settled = taken();
    for (CohesiveEdge& one : all) {
        one.needed -= one.taken;
        one.taken = 0;
        one.before = one.share;
    }
}

void OpeningEdges::shell_changes() {
    if (is_solved) settle();
    is_solved = false;
}

void OpeningEdges::shell_changed(const Positions& x) {
    for (CohesiveEdge& one : all) one.at = one.columns_of(x);
}

void OpeningEdges::solved(const Positions& x) {
    is_solved = true;
    for (CohesiveEdge& one : all) {
        const double against = one.against_until(x);
        one.taken = std::clamp(0.5 * (one.before + one.share) * against, 0.0, one.needed);
        one.closes = against < 0;
    }
}

void OpeningEdges::finish() {
    settle();
    std::erase_if(all,
                  [](const CohesiveEdge& one) { return one.share == 0 || one.needed <= 0 || one.closes; });
    finished = all;
}

double OpeningEdges::taken() const {
    double sum = settled;
    for (const CohesiveEdge& one : all) sum += one.taken;
    return sum;
}

double OpeningEdges::value(const Positions& x) const {
    double sum = 0;
    for (const CohesiveEdge& one : all) sum += one.share * one.against_until(x);
    return sum;
}

void OpeningEdges::add_gradient(const Positions&, Positions& gradient) const {
    for (const CohesiveEdge& one : all) one.add(-one.share, gradient);
}

}  // namespace sherd
