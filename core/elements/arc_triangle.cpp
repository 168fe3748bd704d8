// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/arc_triangle.h"

#include <Eigen/LU>

namespace sherd {
namespace {

/// Derivative of the Green strain by the squares of the sides' lengths, 1/m^2, a column for each side. For a
/// side between corners i and j, whose shape functions have the gradients g_i and g_j, the strain is -sym(g_i
/// g_j^T) / 2.
Matrix3d strain_of_squares(const MembraneTriangle& triangle) {
    Matrix3d strain;
    for (int side = 0; side < 3; ++side) {
        const Vector2d i = triangle.derivatives.row((side + 1) % 3),
                       j = triangle.derivatives.row((side + 2) % 3);
        strain.col(side) = -0.5 * Vector3d(i[0] * j[0], i[1] * j[1], i[0] * j[1] + i[1] * j[0]);
    }
    return strain;
}

/// Vector along a side, m.
Vector3d along(const TrianglePositions& x, int side) {
    return x.col((side + 2) % 3) - x.col((side + 1) % 3);
}

/// Vectors along the sides at rest, m, in the rest frame, a column for each.
Eigen::Matrix<double, 2, 3> rest_sides(const MembraneTriangle& triangle) {
    const Eigen::Matrix2d from_first = triangle.derivatives.bottomRows<2>().inverse();
    Eigen::Matrix<double, 2, 3> sides;
    sides << from_first.col(1) - from_first.col(0), -from_first.col(1), from_first.col(0);
    return sides;
}

/// The energy's derivative by the squares of the arcs, N/m.
Vector3d forces(const ArcTriangle& triangle, const Vector3d& strain) {
    const MembraneTriangle& membrane = triangle.membrane;
    return membrane.area * strain_of_squares(membrane).transpose() * (membrane.elasticity * strain);
}

/// Square of a side's arc over the square of its chord.
Vector3d stretch(const ArcTriangle& triangle, const Vector3d& curvature) {
    return Vector3d::Ones() + triangle.rest_squares.cwiseProduct(curvature.cwiseAbs2()) / 12;
}

/// The derivative of the squares of the arcs by positions and curvature.
Eigen::Matrix<double, 3, 12> slopes_of_arcs(const ArcTriangle& triangle, const TrianglePositions& x,
                                            const Vector3d& curvature) {
    const Vector3d longer = stretch(triangle, curvature), squares = side_squares(x);
    Eigen::Matrix<double, 3, 12> slopes = Eigen::Matrix<double, 3, 12>::Zero();
    for (int side = 0; side < 3; ++side) {
        const Eigen::RowVector3d slope = 2 * longer[side] * along(x, side).transpose();
        slopes.block<1, 3>(side, 3 * ((side + 1) % 3)) = -slope;
        slopes.block<1, 3>(side, 3 * ((side + 2) % 3)) = slope;
        slopes(side, 9 + side) = squares[side] * triangle.rest_squares[side] * curvature[side] / 6;
    }
    return slopes;
}

}  // namespace

Vector3d side_squares(const TrianglePositions& x) {
    return {along(x, 0).squaredNorm(), along(x, 1).squaredNorm(), along(x, 2).squaredNorm()};
}

Vector3d arc_sagittas(const Vector3d& rest_squares, const TrianglePositions& x, const Vector3d& curvature) {
    return side_squares(x).cwiseProduct(rest_squares).cwiseProduct(curvature.cwiseAbs2()) / 12;
}

Vector3d green_strain(const ArcTriangle& triangle, const TrianglePositions& x, const Vector3d& curvature) {
    const Vector3d longer = arc_sagittas(triangle.rest_squares, x, curvature) - triangle.start;
    return green_strain(triangle.membrane, x) + strain_of_squares(triangle.membrane) * longer;
}

double value(const ArcTriangle& triangle, const TrianglePositions& x, const Vector3d& curvature) {
    const Vector3d strain = green_strain(triangle, x, curvature);
    return 0.5 * triangle.membrane.area * strain.dot(triangle.membrane.elasticity * strain);
}

ArcGradient gradient(const ArcTriangle& triangle, const TrianglePositions& x, const Vector3d& curvature) {
    const Eigen::Matrix<double, 12, 1> all = slopes_of_arcs(triangle, x, curvature).transpose() *
                                             forces(triangle, green_strain(triangle, x, curvature));
    return {all.head<9>().reshaped(3, 3), all.tail<3>()};
}

Eigen::Matrix<double, 12, 12> hessian(const ArcTriangle& triangle, const TrianglePositions& x,
                                      const Vector3d& curvature, bool convex) {
    const MembraneTriangle& membrane = triangle.membrane;
    const Vector3d strain = green_strain(triangle, x, curvature), force = forces(triangle, strain);
    const Eigen::Matrix<double, 3, 12> slopes = slopes_of_arcs(triangle, x, curvature);
    const Matrix3d strains = strain_of_squares(membrane);
    const Matrix3d stiffness = membrane.area * strains.transpose() * membrane.elasticity * strains;
    Eigen::Matrix<double, 12, 12> h = slopes.transpose() * stiffness * slopes;

    // A force on the square of an arc is a force on the square of its chord multiplied by stretch(). The
    // excess over the chord's own force is added to the stress.
    Vector3d stress = membrane.elasticity * strain;
    const Eigen::Matrix<double, 2, 3> sides = rest_sides(membrane);
    const Vector3d more =
        2 / membrane.area * force.cwiseProduct(stretch(triangle, curvature) - Vector3d::Ones());
    for (int side = 0; side < 3; ++side) {
        const Vector2d t = sides.col(side);
        stress += more[side] * Vector3d(t[0] * t[0], t[1] * t[1], t[0] * t[1]);
    }
    const Matrix3d geometric = membrane.area * geometric_stiffness(membrane, stress, convex);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) h.block<3, 3>(3 * a, 3 * b).diagonal().array() += geometric(a, b);

    const Vector3d squares = side_squares(x);
    for (int side = 0; side < 3; ++side) {
        const double l2 = triangle.rest_squares[side];
        if (!convex || force[side] > 0) h(9 + side, 9 + side) += force[side] * squares[side] * l2 / 6;
        if (convex) continue;
        const Vector3d mixed = force[side] * l2 * curvature[side] / 3 * along(x, side);
        for (const auto& [corner, sign] : {std::pair((side + 1) % 3, -1.0), std::pair((side + 2) % 3, 1.0)}) {
            h.block<3, 1>(3 * corner, 9 + side) += sign * mixed;
            h.block<1, 3>(9 + side, 3 * corner) += sign * mixed.transpose();
        }
    }
    return h;
}

}  // namespace sherd
