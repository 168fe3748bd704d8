// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/membrane/side_curvature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sherd {

SideCurvature::SideCurvature(const Shell& shell, const Folds& folds)
    : shell(shell), folds(folds), patches(shell, folds, std::numbers::pi / 4), sides(shell.triangles.size()) {
    for (Index face = 0; face < static_cast<Index>(sides.size()); ++face)
        for (int side = 0; side < 3; ++side) update(face, side);
}

void SideCurvature::update(Index face, int side) {
    const Index fold = patches.fold_at(face, side);
    TriangleEdge first{face, side};
    if (fold >= folds.folds_of_edges()) {
        const auto both = *patches.sides_of(fold - folds.folds_of_edges());
        first = both[0];
        const TriangleEdge& other = both[both[0].triangle == face ? 1 : 0];
        if (other.triangle < face) {  // both triangles have the same curvature, and `other` is up to date
            sides[face][side] = sides[other.triangle][other.corner];
            return;
        }
    }
    const double angle = direction_of_side(patches.triangle(first.triangle), first.corner);
    const double c = std::cos(angle), s = std::sin(angle);
    sides[face][side] = patches.shares(first, {c * c, s * s, c * s});
}

void SideCurvature::follow(const ShellChange& change) {
    const Patches::Change seen = patches.follow(change);
    sides.resize(shell.triangles.size());
    for (Index face = 0; face < static_cast<Index>(sides.size()); ++face) {
        const bool changed = std::ranges::binary_search(seen.faces, face);
        for (int side = 0; side < 3; ++side) {
            std::vector<Patches::Share>& sum = sides[face][side];
            for (Patches::Share& share : sum) share.fold = seen.now(share.fold);
            if (changed || seen.concerns(sum)) update(face, side);
        }
    }
}

Vector3d SideCurvature::of(std::size_t face, const VectorXd& angles) const {
    Vector3d sums = Vector3d::Zero();
    for (int side = 0; side < 3; ++side)
        for (const auto& [fold, weight] : sides[face][side]) sums[side] += weight * angles[fold];
    return sums;
}

}  // namespace sherd
