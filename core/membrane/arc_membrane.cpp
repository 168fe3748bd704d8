// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/membrane/arc_membrane.h"

#include <algorithm>

namespace sherd {
namespace {

using ArcHessian = Eigen::Matrix<double, 12, 12>;

/// How the curvature along the sides of a face changes with the position of a vertex, 1/m^2, a row for each
/// side. The face's own vertices come first, in its order.
struct BentSides {
    Index vertex;
    Matrix3d slope;
};

Matrix3d& slope_at(std::vector<BentSides>& all, Index vertex) {
    auto at = std::ranges::find(all, vertex, &BentSides::vertex);
    if (at == all.end()) at = all.insert(at, {vertex, Matrix3d::Zero()});
    return at->slope;
}

/// The block of two vertices in the Hessian of a face, of its derivatives by positions and curvature.
Matrix3d block(const ArcHessian& h, const std::vector<BentSides>& all, std::size_t a, std::size_t b) {
    Matrix3d sum = all[a].slope.transpose() * h.bottomRightCorner<3, 3>() * all[b].slope;
    const auto row = static_cast<Eigen::Index>(3 * a), column = static_cast<Eigen::Index>(3 * b);
    if (a < 3) sum += h.block<3, 3>(row, 9) * all[b].slope;
    if (b < 3) sum += all[a].slope.transpose() * h.block<3, 3>(9, column);
    if (a < 3 && b < 3) sum += h.block<3, 3>(row, column);
    return sum;
}

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
        triangles.push_back(
            {shell.triangles[face].membrane, squares, bows(squares, rest, curvature.of(face, angles))});
    }
}

void ArcMembrane::start_from(const Positions& x, double scale) {
    const VectorXd angles = folds.angles(x);
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        const TrianglePositions start = corners(x, face);
        auto& [membrane, squares, bow] = triangles[face];
        membrane = membrane_triangle(start, scale * shell.triangles[face].membrane.elasticity);
        bow = bows(squares, start, curvature.of(face, angles));
    }
}

void ArcMembrane::topology_changed(const ShellChange& change, const StepContext&) {
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
    const std::vector<ArcGradient> of_faces = gradients(x, folds.angles(x));
    for (std::size_t face = 0; face < of_faces.size(); ++face)
        for (int v = 0; v < 3; ++v)
            gradient.col(shell.triangles[face].vertices[v]) += of_faces[face].by_positions.col(v);
    folds.add_gradient(x, moments(of_faces), gradient);
}

void ArcMembrane::add_hessian(const Positions& x, Curvature kind, BlockMatrix& hessian) const {
    const VectorXd angles = folds.angles(x);
    const std::vector<Folds::Slope> slopes = folds.slopes(x);
    std::vector<BentSides> local;
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        local.clear();
        for (const Index vertex : shell.triangles[face].vertices) local.push_back({vertex, Matrix3d::Zero()});
        for (int side = 0; side < 3; ++side)
            for (const auto& [fold, weight] : curvature.shares(face, side))
                for (int v = 0; v < 4; ++v)
                    if (const Index vertex = slopes[fold].vertices[v]; vertex >= 0)
                        slope_at(local, vertex).row(side) +=
                            weight * slopes[fold].gradient.col(v).transpose();
        const ArcHessian own = sherd::hessian(triangles[face], corners(x, face), curvature.of(face, angles),
                                              kind == Curvature::convex);
        for (std::size_t a = 0; a < local.size(); ++a)
            for (std::size_t b = 0; b <= a; ++b)
                hessian.add(local[a].vertex, local[b].vertex, block(own, local, a, b));
    }
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
