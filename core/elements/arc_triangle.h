// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/membrane.h"

namespace sherd {

// A membrane triangle whose sides are arcs of the curved sheet instead of chords through it. To third order
// in its length, the square of a side's arc is
//     d = |x_i - x_j|^2 (1 + l^2 k^2 / 12)
// with the sheet's curvature k along the side and the side's length l at rest. The triangle has the Green
// strain of a flat triangle whose sides have these lengths. Where k is zero it is the constant-strain
// triangle (membrane.h). Side c is opposite to corner c.

/// A triangle whose energy depends on the positions of its corners and on the curvature along its sides, [3]
/// 1/m.
struct ArcTriangle {
    MembraneTriangle membrane;
    Vector3d rest_squares;  ///< m^2, l^2 of the sides
    Vector3d start;         ///< m^2, arc_sagittas() in the shape where the energy is zero
};

/// The squares of the sides' lengths, m^2.
Vector3d side_squares(const TrianglePositions& x);
/// Increase, [3] m^2, of the squares of the sides' lengths at x that the curvature along them, [3] 1/m,
/// causes. rest_squares: [3] m^2, squares of the sides' lengths at rest.
Vector3d arc_sagittas(const Vector3d& rest_squares, const TrianglePositions& x, const Vector3d& curvature);

/// Green strain (00, 11, 2 * 01) in the rest frame.
Vector3d green_strain(const ArcTriangle& triangle, const TrianglePositions& x, const Vector3d& curvature);
/// Energy, J.
double value(const ArcTriangle& triangle, const TrianglePositions& x, const Vector3d& curvature);

struct ArcGradient {
    TrianglePositions by_positions;  ///< N
    Vector3d by_curvature;           ///< J m
};
ArcGradient gradient(const ArcTriangle& triangle, const TrianglePositions& x, const Vector3d& curvature);

/// Second derivatives of the energy by the positions, coordinate fastest, then by the three curvatures.
/// `convex` drops the compressive part of the geometric stiffness and its coupling with curvature, which
/// makes the matrix positive semidefinite.
Eigen::Matrix<double, 12, 12> hessian(const ArcTriangle& triangle, const TrianglePositions& x,
                                      const Vector3d& curvature, bool convex);

}  // namespace sherd
