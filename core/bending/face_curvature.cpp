// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/face_curvature.h"

#include <Eigen/QR>
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

/// What is left of a curvature once the face has bent at its free sides, each of which adds a multiple of its
/// column of `free`, in the way that costs the least energy.
Vector3d relaxed(const Vector3d& curvature, const Eigen::Matrix3Xd& free, const Matrix3d& elasticity) {
    const Matrix3d root = elasticity.llt().matrixU();
    const Eigen::ColPivHouseholderQR<Eigen::Matrix3Xd> bent(root * free);
    return curvature - free * bent.solve(root * curvature);
}

}  // namespace

FaceCurvature::FaceCurvature(const Shell& shell, std::span<const TriangleEdge> mirrors)
    : shell(shell),
      mirror_count(static_cast<Index>(mirrors.size())),
      mirrors(mirrors.begin(), mirrors.end()) {
    build();
}

void FaceCurvature::build() {
    triangles.clear();
    for (const TriangleStencil& triangle : shell.triangles)
        triangles.push_back(plane_triangle(columns(shell.rest, triangle.vertices)));
    fold_of_side.assign(triangles.size(), {-1, -1, -1});
    for (Index m = 0; m < mirror_count; ++m) fold_of_side[mirrors[m].triangle][mirrors[m].corner] = m;
    sides_of_edge.assign(shell.edge_hinge.size(), {});
    const std::vector<std::array<TriangleEdge, 2>> sides = sides_of_hinges(shell);
    for (std::size_t h = 0; h < sides.size(); ++h) {
        const Index edge = shell.hinge_edge[h];
        sides_of_edge[edge] = sides[h];
        for (const auto& [triangle, corner] : sides[h]) fold_of_side[triangle][corner] = mirror_count + edge;
    }
    shares.assign(shell.edge_hinge.size(), {});
    for (const Index edge : shell.hinge_edge) shares[edge] = shares_of(edge);
    faces.assign(triangles.size(), {});
    for (Index face = 0; face < static_cast<Index>(faces.size()); ++face) update_face(face);
}

void FaceCurvature::follow(const ShellChange& change) {
    if (!change.faces.empty()) return build();
    std::vector<char> gone(mirror_count + shares.size(), 0);  // by fold
    std::vector<Index> changed;                               // faces
    const auto add_faces_of = [&](std::size_t edge) {
        for (const auto& [triangle, corner] : sides_of_edge[edge]) changed.push_back(triangle);
    };
    for (std::size_t edge = 0; edge < shares.size(); ++edge) {
        if (shares[edge].empty() || shell.edge_hinge[edge] >= 0) continue;
        gone[mirror_count + edge] = 1;
        shares[edge].clear();
        for (const auto& [triangle, corner] : sides_of_edge[edge]) fold_of_side[triangle][corner] = -1;
        add_faces_of(edge);
    }
    for (std::size_t edge = 0; edge < shares.size(); ++edge)
        if (std::ranges::any_of(shares[edge], [&](const Share& share) { return gone[share.fold] != 0; })) {
            shares[edge] = shares_of(static_cast<Index>(edge));
            add_faces_of(edge);
        }
    shares.resize(shell.edge_hinge.size());
    sides_of_edge.resize(shell.edge_hinge.size());
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const Index face : changed) update_face(face);
}

FaceCurvature::Unfolded FaceCurvature::across(const Unfolded& from, int side) const {
    const auto& [first, second] = sides_of_edge[fold_of_side[from.triangle][side] - mirror_count];
    const TriangleEdge& other = first.triangle == from.triangle && first.corner == side ? second : first;
    // The common edge runs the other way in the other triangle.
    const double turn = direction_of_side(triangles[from.triangle], side) -
                        direction_of_side(triangles[other.triangle], other.corner) - std::numbers::pi;
    return {other.triangle, from.angle + turn};
}

std::vector<FaceCurvature::Unfolded> FaceCurvature::grown(const std::vector<Unfolded>& patch) const {
    std::vector<Unfolded> all = patch;
    for (const Unfolded& at : patch)
        for (int side = 0; side < 3; ++side) {
            if (fold_of_side[at.triangle][side] < mirror_count) continue;
            const Unfolded next = across(at, side);
            // One that is next to both triangles is unfolded across either edge.
            if (std::ranges::find(patch, next.triangle, &Unfolded::triangle) == patch.end())
                all.push_back(next);
        }
    return all;
}

Vector3d FaceCurvature::angle_of(const Unfolded& at, int side) const {
    const auto own = [this](const Unfolded& of, int corner) {
        return turned_tensor(tangent_angle(triangles[of.triangle], corner), of.angle);
    };
    const Index fold = fold_of_side[at.triangle][side];
    if (fold < mirror_count) return 2 * own(at, side);
    const Unfolded other = across(at, side);
    const auto& [first, second] = sides_of_edge[fold - mirror_count];
    return own(at, side) + own(other, first.triangle == other.triangle ? first.corner : second.corner);
}

std::vector<FaceCurvature::FoldAngle> FaceCurvature::folds_of(const std::vector<Unfolded>& patch) const {
    std::vector<FoldAngle> folds;
    for (const Unfolded& at : patch)
        for (int side = 0; side < 3; ++side) {
            const Index fold = fold_of_side[at.triangle][side];
            if (fold < 0) continue;
            auto known = std::ranges::find(folds, fold, &FoldAngle::fold);
            if (known == folds.end()) known = folds.insert(known, {fold, Vector3d::Zero(), 0});
            known->angle += angle_of(at, side);
            ++known->views;
        }
    // Where a curved patch closes around a vertex, its two ends see a fold in different directions. The mean
    // does not depend on their order.
    for (FoldAngle& fold : folds) fold.angle /= fold.views;
    return folds;
}

std::vector<FaceCurvature::Share> FaceCurvature::shares_of(Index edge) const {
    const auto& [first, second] = sides_of_edge[edge];
    const PlaneTriangle &near = triangles[first.triangle], &far = triangles[second.triangle];
    const double length = 2 * near.area / height_over_side(near, first.corner);
    const auto angles_of = [&](const std::vector<FoldAngle>& folds) {
        AnglesOfFolds angles(folds.size(), 3);
        for (std::size_t f = 0; f < folds.size(); ++f)
            angles.row(static_cast<Eigen::Index>(f)) = invariant(folds[f].angle) / length;
        return angles;
    };
    std::vector<Unfolded> patch{{first.triangle, 0}};
    patch.push_back(across(patch.front(), first.corner));
    std::vector<FoldAngle> folds = folds_of(patch);
    if (sight(angles_of(folds)) < sees_well) folds = folds_of(grown(patch));

    // Alone, the angle is shared like a constant curvature across the edge.
    const double height = height_over_side(near, first.corner);
    VectorXd weights = VectorXd::Zero(static_cast<Eigen::Index>(folds.size()));
    const auto own = std::ranges::find(folds, mirror_count + edge, &FoldAngle::fold) - folds.begin();
    weights[own] = height / (height + height_over_side(far, second.corner));
    weights = corrected(weights, angles_of(folds), invariant(tangent_angle(near, first.corner)) / length);
    std::vector<Share> all;
    for (std::size_t f = 0; f < folds.size(); ++f)
        all.push_back({folds[f].fold, weights[static_cast<Eigen::Index>(f)]});
    return all;
}

void FaceCurvature::update_face(Index face) {
    std::vector<Term>& terms = faces[face];
    terms.clear();
    const auto add = [&terms](Index fold, const Vector3d& per_angle) {
        const auto known = std::ranges::find(terms, fold, &Term::fold);
        if (known == terms.end())
            terms.push_back({fold, per_angle});
        else
            known->per_angle += per_angle;
    };
    Eigen::Matrix3Xd free(3, 0);
    for (int side = 0; side < 3; ++side) {
        const Index fold = fold_of_side[face][side];
        const Vector3d curvature = curvature_of_tangent(triangles[face], side);
        if (fold < 0) {
            free.conservativeResize(Eigen::NoChange, free.cols() + 1);
            free.rightCols<1>() = curvature;
        } else if (fold < mirror_count) {
            add(fold, 0.5 * curvature);
        } else {
            const TriangleEdge& first = sides_of_edge[fold - mirror_count][0];
            const double sign = first.triangle == face && first.corner == side ? 1 : -1;
            if (sign < 0) add(fold, curvature);
            for (const Share& share : shares[fold - mirror_count])
                add(share.fold, sign * share.weight * curvature);
        }
    }
    if (free.cols() == 0) return;
    const Matrix3d& elasticity = shell.triangles[face].membrane.elasticity;
    for (Term& term : terms) term.per_angle = relaxed(term.per_angle, free, elasticity);
}

}  // namespace sherd
