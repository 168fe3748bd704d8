// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/patches.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sherd {
namespace {

/// Singular values of a patch's angles, over the edge's length, under which it is grown, and under which what
/// it cannot see is left as it is.
constexpr double sees_well = 0.2, sees_hardly = 0.05;

/// A tensor's components with the weight that makes their sum of squares the same in all frames.
Vector3d invariant(const Vector3d& tensor) {
    return {tensor[0], tensor[1], std::numbers::sqrt2 * tensor[2]};
}

using AnglesOfFolds = Eigen::MatrixXd;  ///< [folds, 3]; JacobiSVD needs a dynamic number of columns, too
using Decomposition = Eigen::JacobiSVD<AnglesOfFolds>;

/// The smallest change of `weights` after which their sum of the folds' angles is `target`, as far as the
/// angles see it.
VectorXd corrected(const VectorXd& weights, const AnglesOfFolds& angles, const Vector3d& target) {
    const Decomposition svd(angles, Eigen::ComputeThinU | Eigen::ComputeThinV);
    VectorXd missing = svd.matrixV().transpose() * (target - angles.transpose() * weights);
    for (Eigen::Index i = 0; i < missing.size(); ++i) {
        const double size = svd.singularValues()[i];
        missing[i] = size > sees_hardly ? missing[i] / size : 0;
    }
    return weights + svd.matrixU() * missing;
}

/// How well the angles tell curvatures from each other: the smallest singular value.
double sight(const AnglesOfFolds& angles) {
    return angles.rows() < 3 ? 0 : Decomposition(angles).singularValues()[2];
}

}  // namespace

void Patches::build() {
    triangles.clear();
    for (const TriangleStencil& triangle : shell.triangles)
        triangles.push_back(plane_triangle(columns(shell.rest, triangle.vertices)));
    fold_of_side.assign(triangles.size(), {-1, -1, -1});
    const auto is_smooth = [this](Index fold) { return std::abs(folds.rest_angle(fold)) <= sharpest; };
    for (Index m = 0; m < folds.folds_of_edges(); ++m)
        if (const auto& [triangle, corner] = folds.mirror_side(m); is_smooth(m))
            fold_of_side[triangle][corner] = m;
    sides_of_edge.assign(shell.edge_hinge.size(), {});
    const std::vector<std::array<TriangleEdge, 2>> sides = sides_of_hinges(shell);
    for (std::size_t h = 0; h < sides.size(); ++h) {
        const Index edge = shell.hinge_edge[h], fold = folds.folds_of_edges() + edge;
        sides_of_edge[edge] = sides[h];
        if (!is_smooth(fold)) continue;
        for (const auto& [triangle, corner] : sides[h]) fold_of_side[triangle][corner] = fold;
    }
}

std::vector<Patches::Removed> Patches::forget_removed() {
    std::vector<Removed> removed;
    for (Index edge = 0; edge < static_cast<Index>(sides_of_edge.size()); ++edge) {
        const auto sides = sides_of(edge);
        if (!sides || shell.edge_hinge[edge] >= 0) continue;
        for (const auto& [triangle, corner] : *sides) fold_of_side[triangle][corner] = -1;
        removed.push_back({edge, *sides});
    }
    sides_of_edge.resize(shell.edge_hinge.size());
    return removed;
}

std::optional<std::array<TriangleEdge, 2>> Patches::sides_of(Index edge) const {
    const auto& [triangle, corner] = sides_of_edge[edge][0];
    if (fold_of_side[triangle][corner] != folds.folds_of_edges() + edge) return std::nullopt;
    return sides_of_edge[edge];
}

double Patches::side_length(const TriangleEdge& side) const {
    const PlaneTriangle& triangle = triangles[side.triangle];
    return 2 * triangle.area / height_over_side(triangle, side.corner);
}

Patches::Unfolded Patches::across(const Unfolded& from, int side) const {
    const auto& [first, second] = sides_of_edge[fold_of_side[from.triangle][side] - folds.folds_of_edges()];
    const TriangleEdge& other = first.triangle == from.triangle && first.corner == side ? second : first;
    // The common edge runs the other way in the other triangle.
    const double turn = direction_of_side(triangles[from.triangle], side) -
                        direction_of_side(triangles[other.triangle], other.corner) - std::numbers::pi;
    return {other.triangle, from.angle + turn};
}

std::vector<Patches::Unfolded> Patches::grown(const std::vector<Unfolded>& patch) const {
    std::vector<Unfolded> all = patch;
    for (const Unfolded& at : patch)
        for (int side = 0; side < 3; ++side) {
            if (fold_of_side[at.triangle][side] < folds.folds_of_edges()) continue;
            const Unfolded next = across(at, side);
            // One that is next to both triangles is unfolded across either edge.
            if (std::ranges::find(patch, next.triangle, &Unfolded::triangle) == patch.end())
                all.push_back(next);
        }
    return all;
}

Vector3d Patches::angle_of(const Unfolded& at, int side) const {
    const auto own = [this](const Unfolded& of, int corner) {
        return turned_tensor(tangent_angle(triangles[of.triangle], corner), of.angle);
    };
    const Index fold = fold_of_side[at.triangle][side];
    if (fold < folds.folds_of_edges()) return 2 * own(at, side);
    const Unfolded other = across(at, side);
    const auto& [first, second] = sides_of_edge[fold - folds.folds_of_edges()];
    return own(at, side) + own(other, first.triangle == other.triangle ? first.corner : second.corner);
}

std::vector<Patches::FoldAngle> Patches::folds_of(const std::vector<Unfolded>& patch) const {
    std::vector<FoldAngle> seen;
    for (const Unfolded& at : patch)
        for (int side = 0; side < 3; ++side) {
            const Index fold = fold_of_side[at.triangle][side];
            if (fold < 0) continue;
            auto known = std::ranges::find(seen, fold, &FoldAngle::fold);
            if (known == seen.end()) known = seen.insert(known, {fold, Vector3d::Zero(), 0});
            known->angle += angle_of(at, side);
            ++known->views;
        }
    // Where a curved patch closes around a vertex, its two ends see a fold in different directions. The mean
    // does not depend on their order.
    for (FoldAngle& fold : seen) fold.angle /= fold.views;
    return seen;
}

std::vector<Patches::Share> Patches::shares(const TriangleEdge& side, const Vector3d& target,
                                            std::optional<Share> start) const {
    const double length = side_length(side);
    const auto angles_of = [&](const std::vector<FoldAngle>& there) {
        AnglesOfFolds angles(there.size(), 3);
        for (std::size_t f = 0; f < there.size(); ++f)
            angles.row(static_cast<Eigen::Index>(f)) = invariant(there[f].angle) / length;
        return angles;
    };
    std::vector<Unfolded> patch{{side.triangle, 0}};
    if (fold_of_side[side.triangle][side.corner] >= folds.folds_of_edges())
        patch.push_back(across(patch.front(), side.corner));
    std::vector<FoldAngle> seen = folds_of(patch);
    if (sight(angles_of(seen)) < sees_well) seen = folds_of(grown(patch));
    if (seen.empty()) return {};

    VectorXd weights = VectorXd::Zero(static_cast<Eigen::Index>(seen.size()));
    if (start) weights[std::ranges::find(seen, start->fold, &FoldAngle::fold) - seen.begin()] = start->weight;
    weights = corrected(weights, angles_of(seen), invariant(target) / length);
    std::vector<Share> all;
    for (std::size_t f = 0; f < seen.size(); ++f)
        all.push_back({seen[f].fold, weights[static_cast<Eigen::Index>(f)]});
    return all;
}

}  // namespace sherd
