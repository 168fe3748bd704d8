// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/membrane/arc_membrane.h"

#include <algorithm>

#include "core/block_columns.h"

namespace sherd {
namespace {

using ArcHessian = Eigen::Matrix<double, 12, 12>;

/// Derivatives, by the position of one vertex, of a face's gradient, which is by the positions of its corners
/// and the curvature along its sides.
using ArcColumns = Eigen::Matrix<double, 12, 3>;

/// Derivative of the curvature along the sides of a face by the position of a vertex.
struct BentSides {
    Index vertex;
    int corner;      ///< corner of the face at the vertex; -1: none
    Matrix3d slope;  ///< 1/m^2, a row for each side
};

Matrix3d& slope_at(std::vector<BentSides>& all, Index vertex) {
    auto at = std::ranges::find(all, vertex, &BentSides::vertex);
    if (at == all.end()) at = all.insert(at, {vertex, -1, Matrix3d::Zero()});
    return at->slope;
}

/// Writes to `all` the derivatives by all vertices on which the curvature along a face's sides depends,
/// ascending.
void find_sides(const std::array<Index, 3>& corners, const SideCurvature& curvature, std::size_t face,
                const std::vector<Folds::Slope>& slopes, std::vector<BentSides>& all) {
    all.clear();
    for (int corner = 0; corner < 3; ++corner) all.push_back({corners[corner], corner, Matrix3d::Zero()});
    for (int side = 0; side < 3; ++side)
        for (const auto& [fold, weight] : curvature.shares(face, side))
            for (int v = 0; v < 4; ++v)
                if (const Index vertex = slopes[fold].vertices[v]; vertex >= 0)
                    slope_at(all, vertex).row(side) += weight * slopes[fold].gradient.col(v).transpose();
    std::ranges::sort(all, {}, &BentSides::vertex);
}

/// Derivatives of a face's gradient by the position of the vertex `at`.
ArcColumns columns_of(const BentSides& at, const ArcHessian& hessian) {
    ArcColumns sum = hessian.rightCols<3>() * at.slope;
    if (at.corner >= 0) sum += hessian.middleCols<3>(3 * at.corner);
    return sum;
}

/// The block of a face's Hessian in the row of the vertex `at`, and the column of a vertex whose columns_of()
/// are `other`.
Matrix3d block(const BentSides& at, const ArcColumns& other) {
    Matrix3d sum = at.slope.transpose() * other.bottomRows<3>();
    if (at.corner >= 0) sum += other.middleRows<3>(3 * at.corner);
    return sum;
}

/// Terms of the Hessian of a face, for all vertices on which it depends.
struct BentFace {
    std::vector<BentSides> sides;
    std::vector<Index> vertices;  ///< ascending
    std::vector<ArcColumns> columns;
};

}  // namespace

ArcMembrane::ArcMembrane(const Shell& shell, const std::vector<MirrorHinge>& mirrors)
    : shell(shell), folds(shell, mirrors), curvature(shell, folds) {
    measure_from_rest();
}

void ArcMembrane::measure_from_rest() {
    const VectorXd angles = folds.rest_angles();
    triangles.clear();
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        const TrianglePositions rest = corners(shell.rest, face);
        const Vector3d squares = side_squares(rest);
        triangles.push_back({shell.triangles[face].membrane, squares,
                             arc_sagittas(squares, rest, curvature.of(face, angles))});
    }
}

void ArcMembrane::start_from(const Positions& x, double scale) {
    const VectorXd angles = folds.angles(x);
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        const TrianglePositions start = corners(x, face);
        auto& [membrane, squares, bow] = triangles[face];
        membrane = membrane_triangle(start, scale * shell.triangles[face].membrane.elasticity);
        bow = arc_sagittas(squares, start, curvature.of(face, angles));
    }
}

void ArcMembrane::topology_changed(const ShellChange& change, const StepContext&) {
    folds.follow(change);
    curvature.follow(change);
    measure_from_rest();
}

TrianglePositions ArcMembrane::corners(const Positions& x, std::size_t face) const {
    return columns(x, shell.triangles[face].vertices);
}

Eigen::Matrix3Xd ArcMembrane::strains(const Positions& x) const {
    const VectorXd angles = folds.angles(x);
    Eigen::Matrix3Xd all(3, triangles.size());
    for (std::size_t face = 0; face < triangles.size(); ++face)
        all.col(static_cast<Eigen::Index>(face)) =
            green_strain(triangles[face], corners(x, face), curvature.of(face, angles));
    return all;
}

double ArcMembrane::value(const Positions& x) const {
    const VectorXd angles = folds.angles(x);
    double sum = 0;
    for (std::size_t face = 0; face < triangles.size(); ++face)
        sum += sherd::value(triangles[face], corners(x, face), curvature.of(face, angles));
    return sum;
}

std::vector<ArcGradient> ArcMembrane::gradients(const Positions& x, const VectorXd& angles) const {
    std::vector<ArcGradient> all;
    for (std::size_t face = 0; face < triangles.size(); ++face)
        all.push_back(sherd::gradient(triangles[face], corners(x, face), curvature.of(face, angles)));
    return all;
}

VectorXd ArcMembrane::moments(const std::vector<ArcGradient>& of_faces) const {
    VectorXd all = VectorXd::Zero(folds.size());
    for (std::size_t face = 0; face < of_faces.size(); ++face)
        for (int side = 0; side < 3; ++side)
            for (const auto& [fold, weight] : curvature.shares(face, side))
                all[fold] += weight * of_faces[face].by_curvature[side];
    return all;
}

std::vector<MirrorGradient> ArcMembrane::mirror_gradients(const Positions& x) const {
    return folds.mirror_gradients(x, moments(gradients(x, folds.angles(x))));
}

void ArcMembrane::add_gradient(const Positions& x, Positions& gradient) const {
    const std::vector<Index> present = folds.present();
    const std::vector<Folds::Slope> slopes = folds.slopes(x, present);
    const std::vector<ArcGradient> of_faces = gradients(x, folds.angles(slopes, present));
    for (std::size_t face = 0; face < of_faces.size(); ++face)
        for (int v = 0; v < 3; ++v)
            gradient.col(shell.triangles[face].vertices[v]) += of_faces[face].by_positions.col(v);
    folds.add_gradient(slopes, moments(of_faces), gradient, present);
}

void ArcMembrane::add_hessian(const Positions& x, Curvature kind, BlockMatrix& hessian) const {
    const VectorXd angles = folds.angles(x);
    const std::vector<Folds::Slope> slopes = folds.slopes(x);
    hessian.add_elements<BentFace>(
        triangles.size(),
        [&](std::size_t face, BentFace& local) {
            find_sides(shell.triangles[face].vertices, curvature, face, slopes, local.sides);
            const ArcHessian own = sherd::hessian(triangles[face], corners(x, face),
                                                  curvature.of(face, angles), kind == Curvature::convex);
            local.vertices.clear();
            local.columns.clear();
            for (const BentSides& at : local.sides) {
                local.vertices.push_back(at.vertex);
                local.columns.push_back(columns_of(at, own));
            }
            return true;
        },
        [&](BlockMatrix::Columns& columns, std::size_t, const BentFace& local) {
            columns.add_all(local.vertices, [&](std::size_t a, std::size_t b) {
                return block(local.sides[a], local.columns[b]);
            });
        });
    if (kind == Curvature::exact) folds.add_hessian(x, moments(gradients(x, angles)), hessian);
}

void ArcMembrane::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    std::vector<Index> vertices;
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        const std::array<Index, 3>& own = shell.triangles[face].vertices;
        vertices.assign(own.begin(), own.end());
        for (int side = 0; side < 3; ++side)
            for (const auto& [fold, weight] : curvature.shares(face, side)) folds.collect(fold, vertices);
        add_pairs(pairs, std::span<const Index>(vertices));
    }
}

}  // namespace sherd
