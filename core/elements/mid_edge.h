// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/membrane.h"

namespace sherd {

// The mid-edge view of a bent triangle: at the middle of each side the sheet has a tangent, and the angle
// between this tangent and the triangle's facet measures the curvature there. Side c is opposite to corner c.
// Curvatures are the second derivatives of the sheet's height over the facet, (00, 11, 2 * 01) in the
// triangle's rest frame, 1/m, like Green strains (membrane.h). They are positive where the sheet bends
// towards the facet's normal.

/// A triangle at rest, laid into the plane of its rest frame.
struct PlaneTriangle {
    Eigen::Matrix<double, 2, 3> corners;  ///< m
    double area;                          ///< m^2
};

PlaneTriangle plane_triangle(const TrianglePositions& rest);

/// Height, m, of corner c over side c.
double height_over_side(const PlaneTriangle& triangle, int side);

/// The angle, rad, from the first axis of the frame to the side, which runs in the triangle's order of
/// vertices.
double direction_of_side(const PlaneTriangle& triangle, int side);

/// The angle from the facet to the sheet's tangent at the middle of a side, measured across the side, as a
/// linear function of curvature: the angle, rad, is the dot product of the result, m, with the curvature.
/// This is exact for a quadratic surface through the three corners. With the side's length l, its unit vector
/// t, the outward unit normal n, and the opposite corner at (d, -h) from its middle along t and n, the result
/// has the components 00, 11 and 01 of
///     h / 2 n n^T - d sym(t n^T) + (d^2 - l^2 / 4) / (2 h) t t^T.
Vector3d tangent_angle(const PlaneTriangle& triangle, int side);

/// The curvature, 1/m, for each radian of the angle from the facet to the tangent at a side: l / area n n^T.
/// If a constant curvature has caused the angles at the three sides, the sum over the sides is this
/// curvature, as in the Morley triangle.
Vector3d curvature_of_tangent(const PlaneTriangle& triangle, int side);

/// Components (00, 11, 01) of a symmetric tensor in another frame than its own. angle: rad, counterclockwise,
/// from the first axis of the other frame to the first axis of the tensor's own frame.
Vector3d turned_tensor(const Vector3d& tensor, double angle);

}  // namespace sherd
