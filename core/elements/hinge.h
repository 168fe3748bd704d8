// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/vector.h"

namespace sherd {

/// Positions of a hinge's four vertices, m, one column each: the ends x0 and x1 of the edge, then x2 of
/// triangle T0 = (x0, x1, x2) and x3 of triangle T1 = (x0, x3, x1).
using HingePositions = Eigen::Matrix<double, 3, 4>;
/// Second derivatives by a hinge's positions, coordinate fastest.
using HingeHessian = Eigen::Matrix<double, 12, 12>;

/// The rest quantities of a hinge that its energies and its strain use (paper, section 3).
struct RestHinge {
    double edge_length = 0;      ///< |e0|, m
    double area = 0;             ///< m^2, of both triangles together
    double angle = 0;            ///< rest angle, rad
    Eigen::Vector4d cotangents;  ///< c01, c03, c02, c04: of the angles of T0 at x0 and x1, then of T1
};

RestHinge rest_hinge(const HingePositions& rest);

/// Signed dihedral angle in (-pi, pi): zero when flat, positive when the triple product [e0, e1, e2] of the
/// edges from x0 is positive. It is computed with atan2, so that it is exact for large angles, too.
double hinge_angle(const HingePositions& x);

/// Bending strain |e0| / A (theta - rest angle), 1/m: the mean change of normal curvature across the edge
/// (paper, appendix B). Its magnitude times t / 2 is the surface strain of a sheet of thickness t.
double hinge_strain(const RestHinge& rest, const HingePositions& x);

}  // namespace sherd
