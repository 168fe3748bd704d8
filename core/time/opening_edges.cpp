// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/opening_edges.h"

#include <algorithm>
#include <cmath>

namespace sherd {

namespace {

/// Of the largest of the forces: smaller ones are round-off.
constexpr double least_force = 1e-10;

}  // namespace

void OpeningEdges::open(const Opening& edge, const Positions& kept, double gone) {
    if (!(edge.energy > gone)) return;
    Kept one;
    one.edge = edge.edge;
    one.needed = edge.energy - gone;
    one.longest = edge.longest;
    const VectorXd sizes = kept.colwise().norm();
    const double least = least_force * sizes.maxCoeff();
    for (Index v = 0; v < static_cast<Index>(kept.cols()); ++v)
        if (sizes[v] > least) one.vertices.push_back(v);
    one.forces = kept(Eigen::all, one.vertices);
    all.push_back(std::move(one));
}

void OpeningEdges::fade(const Positions& moved, double length) {
    for (Kept& one : all) {
        const double against = -one.forces.cwiseProduct(moved(Eigen::all, one.vertices)).sum();
        one.age += length;
        const double reached = one.taken + one.share * std::max(0.0, against);
        const double before = one.share, left = std::sqrt(std::max(0.0, 1 - reached / one.needed));
        // What is left where the edge closes would drive it: it rests until the edge opens again.
        one.share = against < 0 ? 0 : std::min(left, std::max(0.0, 1 - one.age / one.longest));
        one.taken = left > 0 ? one.taken + std::max(0.0, 0.5 * (before + one.share) * against) : one.needed;
    }
    std::erase_if(all, [](const Kept& one) { return one.taken >= one.needed || one.age >= one.longest; });
}

void OpeningEdges::add_forces(Positions& sum) const {
    for (const Kept& one : all)
        for (std::size_t i = 0; i < one.vertices.size(); ++i)
            sum.col(one.vertices[i]) += one.share * one.forces.col(static_cast<Index>(i));
}

double OpeningEdges::held(Index edge) const {
    const auto found = std::ranges::find(all, edge, &Kept::edge);
    return found == all.end() ? 0 : std::sqrt(1 - found->taken / found->needed);
}

}  // namespace sherd
