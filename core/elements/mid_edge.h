// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/membrane.h"

namespace sherd {

// The mid-edge view of a bent triangle: at the middle of each side the sheet has a tangent, and the angle
// between it and the triangle's facet measures the curvature there. Side c is opposite to corner c.
// Curvatures are (00, 11, 2 * 01) in the triangle's rest frame, 1/m, as Green strains are (membrane.h), of
// the height over the facet along its normal: positive where the sheet bends towards the normal.

/// A triangle at rest, laid into the plane of its rest frame.
struct PlaneTriangle {
    Eigen::Matrix<double, 2, 3> corners;  ///< m
    double area;                          ///< m^2
};

PlaneTriangle plane_triangle(const TrianglePositions& rest);

/// Height, m, of corner c over side c.
double height_over_side(const PlaneTriangle& triangle, int side);

/// The angle, rad, from the first axis of the frame to the side in the triangle's order of vertices.
double direction_of_side(const PlaneTriangle& triangle, int side);

/// The angle, rad, from the facet to the tangent at the middle of a side, across it, as a linear function of
/// curvature: the angle is the dot product of the result, m, with the curvature. Exact for a quadratic
/// surface through the three corners. With the side's length l, its unit vector t, the outward unit normal n,
/// and the opposite corner at (d, -h) from its middle along t and n, the result has the components 00, 11 and
/// 01 of
///     h / 2 n n^T - d sym(t n^T) + (d^2 - l^2 / 4) / (2 h) t t^T.
Vector3d tangent_angle(const PlaneTriangle& triangle, int side);

/// The curvature for each radian of that angle, 1/m: l / area n n^T. Summed over the three sides it returns
/// the curvature that made the angles, as the Morley triangle does.
Vector3d curvature_of_tangent(const PlaneTriangle& triangle, int side);

/// Components 00, 11 and 01 of a symmetric tensor in a frame from whose first axis that of the given frame is
/// rotated by `angle` (rad, counterclockwise).
Vector3d turned_tensor(const Vector3d& tensor, double angle);

}  // namespace sherd
