// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/vector.h"

namespace sherd {

/// Positions of a triangle's three vertices, one column each, m.
using TrianglePositions = Eigen::Matrix<double, 3, 3>;

/// Constant-strain triangle of a St. Venant-Kirchhoff membrane.
struct MembraneTriangle {
    double area = 0;  ///< m^2, at rest
    Eigen::Matrix<double, 3, 2> derivatives =
        decltype(derivatives)::Zero();       ///< d(shape function)/d(rest coordinate), 1/m: F = x *
                                             ///< derivatives
    Matrix3d elasticity = Matrix3d::Zero();  ///< N/m, acting on (E00, E11, 2 E01) in the rest frame
};

/// The membrane of a triangle, whose rest frame has the frame_axes() at rest. elasticity: see
/// membrane_elasticity().
MembraneTriangle membrane_triangle(const TrianglePositions& rest, const Matrix3d& elasticity);

/// The axes of a triangle's frame, one a column, at any positions: unit vectors along the edge from vertex 0
/// to vertex 1, and in the triangle's plane at right angles to it; the cross product of the two is the
/// triangle's normal.
Eigen::Matrix<double, 3, 2> frame_axes(const TrianglePositions& x);

/// Outward normal of the side opposite a corner, in the rest frame, 1/m: its length is one over the height of
/// the corner over the side.
Vector2d side_normal(const MembraneTriangle& triangle, int corner);

/// Deformation gradient F, [3, 2], from the rest frame to space.
Eigen::Matrix<double, 3, 2> deformation_gradient(const MembraneTriangle& triangle,
                                                 const TrianglePositions& x);

/// Green strain (E00, E11, 2 E01) in the rest frame.
Vector3d green_strain(const MembraneTriangle& triangle, const TrianglePositions& x);

/// Geometric stiffness, [3, 3] N/m^3, of a stress (00, 11, 01), N/m, in the rest frame. Entry (a, b), times
/// the area, is the factor of the identity in the Hessian's block of corners a and b. `convex` drops the
/// stress's compressive part.
Matrix3d geometric_stiffness(const MembraneTriangle& triangle, const Vector3d& stress, bool convex);

/// Energy, J.
double value(const MembraneTriangle& triangle, const TrianglePositions& x);
/// dE/dx, N, [3, 3].
TrianglePositions gradient(const MembraneTriangle& triangle, const TrianglePositions& x);
/// Derivative of the energy by the rest positions while x is constant, N, [2, 3], in the rest frame: the area
/// times Eshelby's tensor W - F^T P times the transposed `derivatives`, with the energy W and the first
/// Piola-Kirchhoff stress P, both per area. The derivative by displacements at rest out of the triangle's
/// plane is zero.
Eigen::Matrix<double, 2, 3> rest_gradient(const MembraneTriangle& triangle, const TrianglePositions& x);
/// d2E/dx2, N/m, [9, 9], coordinate fastest. `convex` drops the compressive part of the geometric stiffness,
/// which makes the matrix positive semidefinite.
Eigen::Matrix<double, 9, 9> hessian(const MembraneTriangle& triangle, const TrianglePositions& x,
                                    bool convex);

}  // namespace sherd
