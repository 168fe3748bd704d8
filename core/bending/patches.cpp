// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/patches.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace sherd {
namespace {

/// Limit of the singular values of a patch's AnglesOfFolds. If the smallest is below it, the patch is grown.
/// For singular values that are still below it, weights are not corrected: the corrections would be so large
/// that ears, triangles with one hinge that cracks leave, would be many times too stiff.
constexpr double least_sight = 0.2;
constexpr std::array<Index, 3> no_folds{-1, -1, -1};

/// Components of a tensor (00, 11, 01), of which the last is multiplied such that their sum of squares is the
/// same in all frames.
Vector3d invariant(const Vector3d& tensor) {
    return {tensor[0], tensor[1], std::numbers::sqrt2 * tensor[2]};
}

/// Largest number of folds: all sides of the six triangles of a grown patch. With this bound the matrices
/// below need no heap.
constexpr int most_folds = 18;
/// Angles of the folds of a patch as functions of curvature (FoldAngle), over the length of the patch's side,
/// [folds, 3]. JacobiSVD needs a dynamic number of columns, too.
using AnglesOfFolds = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_folds, 3>;
using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_folds, 1>;  ///< [folds]
using Decomposition = Eigen::JacobiSVD<AnglesOfFolds>;

/// Returns the weights after the smallest change that makes the weighted sum of `angles` equal to `target`,
/// as far as `angles` determine the sum. svd: decomposition of `angles`.
Weights corrected(const Weights& weights, const AnglesOfFolds& angles, const Decomposition& svd,
                  const Vector3d& target) {
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> missing =
        svd.matrixV().transpose() * (target - angles.transpose() * weights);
    for (Eigen::Index i = 0; i < missing.size(); ++i) {
        const double size = svd.singularValues()[i];
        missing[i] = size > least_sight ? missing[i] / size : 0;
    }
    return weights + svd.matrixU() * missing;
}

/// Measure of how well the angles distinguish curvatures: the smallest singular value.
double sight(const AnglesOfFolds& angles, const Decomposition& svd) {
    return angles.rows() < 3 ? 0 : svd.singularValues()[2];
}

Decomposition decomposed(const AnglesOfFolds& angles) {
    if (angles.rows() == 0) return {};  // a lone triangle has no folds
    return Decomposition(angles, Eigen::ComputeThinU | Eigen::ComputeThinV);
}

}  // namespace

double most_side_curvature(double length, double angle) {
    // A grown patch has six triangles, and 13 folds at most. The norm of their shares in a curvature along a
    // side is at most the norm of the target, 1 / length, over the smallest singular value that counts.
    return std::sqrt(13.0) * angle / (least_sight * length);
}

void Patches::build() {
    first_edge = folds.folds_of_edges();
    std::vector<Index> faces(shell.triangles.size()), hinges(shell.hinges.size());
    std::iota(faces.begin(), faces.end(), 0);
    std::iota(hinges.begin(), hinges.end(), 0);
    for (const TriangleStencil& triangle : shell.triangles)
        triangles.push_back(plane_triangle(columns(shell.rest, triangle.vertices)));
    fold_of_side.assign(triangles.size(), no_folds);
    sides_of_edge.assign(shell.edge_hinge.size(), {});
    Change of_all{first_edge, 0, {}, std::vector<char>(folds.size(), 0)};
    enter_mirrors(of_all);
    enter_hinges(hinges, faces, of_all);
}

Patches::Change Patches::follow(const ShellChange& change) {
    Change result{first_edge, folds.folds_of_edges() - first_edge, {}, std::vector<char>(folds.size(), 0)};
    first_edge = folds.folds_of_edges();
    if (result.more_mirrors > 0)
        for (auto& sides : fold_of_side)
            for (Index& fold : sides) fold = result.now(fold);
    drop_removed(result);
    sides_of_edge.resize(shell.edge_hinge.size());
    if (!change.reshaped.empty()) reshape(change, result);
    std::ranges::sort(result.faces);
    result.faces.erase(std::unique(result.faces.begin(), result.faces.end()), result.faces.end());
    return result;
}

void Patches::drop_removed(Change& result) {
    for (Index edge = 0; edge < static_cast<Index>(sides_of_edge.size()); ++edge) {
        const auto sides = sides_of(edge);
        if (!sides || shell.edge_hinge[edge] >= 0) continue;
        result.folds[first_edge + edge] = 1;
        for (const auto& [triangle, corner] : *sides) {
            fold_of_side[triangle][corner] = -1;
            result.faces.push_back(triangle);
        }
    }
}

void Patches::reshape(const ShellChange& change, Change& result) {
    for (const auto& [face, vertices] : change.changed) touch(face, result);
    std::vector<Index> near;
    for (const Index hinge : change.reshaped_hinges)
        for (const TriangleEdge& side : sides_of_edge[shell.hinge_edge[hinge]]) near.push_back(side.triangle);
    triangles.resize(shell.triangles.size());
    fold_of_side.resize(shell.triangles.size());
    for (const auto& [face, parents] : change.reshaped) {
        triangles[face] = plane_triangle(columns(shell.rest, shell.triangles[face].vertices));
        fold_of_side[face] = no_folds;
        result.faces.push_back(face);
        near.push_back(face);
    }
    enter_mirrors(result);
    enter_hinges(change.reshaped_hinges, near, result);
}

void Patches::enter_mirrors(Change& result) {
    for (Index m = 0; m < first_edge; ++m) enter(m, folds.mirror_side(m), result);
}

/// Enters the folds of hinges at their sides. among: faces that have all these sides.
void Patches::enter_hinges(std::span<const Index> hinges, std::span<const Index> among, Change& result) {
    const std::vector<std::array<TriangleEdge, 2>> sides = sides_of_hinges(shell, hinges, among);
    for (std::size_t i = 0; i < hinges.size(); ++i) {
        const Index edge = shell.hinge_edge[hinges[i]];
        sides_of_edge[edge] = sides[i];
        for (const TriangleEdge& side : sides[i]) enter(first_edge + edge, side, result);
    }
}

void Patches::enter(Index fold, const TriangleEdge& side, Change& result) {
    if (!is_smooth(fold)) fold = -1;
    if (fold_of_side[side.triangle][side.corner] == fold) return;
    touch(side.triangle, result);
    fold_of_side[side.triangle][side.corner] = fold;
}

/// Marks a face and its folds as changed: every sum that depends on the face has a share of one of its folds.
void Patches::touch(Index face, Change& result) const {
    result.faces.push_back(face);
    for (const Index fold : fold_of_side[face])
        if (fold >= 0) result.folds[fold] = 1;
}

std::optional<std::array<TriangleEdge, 2>> Patches::sides_of(Index edge) const {
    const auto& [triangle, corner] = sides_of_edge[edge][0];
    if (fold_of_side[triangle][corner] != first_edge + edge) return std::nullopt;
    return sides_of_edge[edge];
}

double Patches::side_length(const TriangleEdge& side) const {
    const PlaneTriangle& triangle = triangles[side.triangle];
    return 2 * triangle.area / height_over_side(triangle, side.corner);
}

Patches::Unfolded Patches::across(const Unfolded& from, int side) const {
    const auto& [first, second] = sides_of_edge[fold_of_side[from.triangle][side] - first_edge];
    const TriangleEdge& other = first.triangle == from.triangle && first.corner == side ? second : first;
    // The common edge has the opposite direction in the other triangle.
    const double turn = direction_of_side(triangles[from.triangle], side) -
                        direction_of_side(triangles[other.triangle], other.corner) - std::numbers::pi;
    return {other.triangle, from.angle + turn};
}

std::vector<Patches::Unfolded> Patches::grown(const std::vector<Unfolded>& patch) const {
    std::vector<Unfolded> all = patch;
    for (const Unfolded& at : patch)
        for (int side = 0; side < 3; ++side) {
            if (fold_of_side[at.triangle][side] < first_edge) continue;
            const Unfolded next = across(at, side);
            // A triangle that adjoins two triangles of the patch is added twice, unfolded across each of the
            // two edges.
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
    if (fold < first_edge) return 2 * own(at, side);
    const Unfolded other = across(at, side);
    const auto& [first, second] = sides_of_edge[fold - first_edge];
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
    // Where a curved patch closes around a vertex, a fold has different directions as seen from different
    // triangles. The mean does not depend on the order of triangles.
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
    if (fold_of_side[side.triangle][side.corner] >= first_edge)
        patch.push_back(across(patch.front(), side.corner));
    std::vector<FoldAngle> seen = folds_of(patch);
    AnglesOfFolds angles = angles_of(seen);
    Decomposition svd = decomposed(angles);
    if (sight(angles, svd) < least_sight) {
        seen = folds_of(grown(patch));
        angles = angles_of(seen);
        svd = decomposed(angles);
    }
    if (seen.empty()) return {};

    Weights weights = Weights::Zero(static_cast<Eigen::Index>(seen.size()));
    if (start) weights[std::ranges::find(seen, start->fold, &FoldAngle::fold) - seen.begin()] = start->weight;
    weights = corrected(weights, angles, svd, invariant(target) / length);
    std::vector<Share> all;
    for (std::size_t f = 0; f < seen.size(); ++f)
        all.push_back({seen[f].fold, weights[static_cast<Eigen::Index>(f)]});
    return all;
}

}  // namespace sherd
