// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "core/elements/hinge.h"
#include "core/elements/membrane.h"

namespace sherd {

/// Elastic constants of a sheet in plane stress, along and across its first material axis, Pa. In terms of
/// Poisson's ratios, Y01 = nu01 Y1 = nu10 Y0 (paper, section 4).
struct Orthotropy {
    double young0 = 0;  ///< Y0, along the first axis
    double young1 = 0;  ///< Y1, along the second axis
    double young01 = 0;
    double shear = 0;  ///< G01
};

/// Describes, with numbers, the inequality that the constants violate; empty if there is none. The energy is
/// positive for every strain if Y0, Y1, G01 > 0 and Y01^2 < Y0 Y1.
std::string broken_inequality(const Orthotropy& constants);

/// Stiffness lambda, N m, of a hinge whose rest edge makes `angle` (rad, of either sign) with the first axis
/// (paper, section 5.1): a fold along the first axis bends the sheet along the second axis. The
/// factor of Material::calibration is not included: for an isotropic sheet the stiffness is the rigidity
/// D = Y t^3 / (12 (1 - nu^2)) at every angle.
double edge_stiffness(const Orthotropy& constants, double thickness, double angle);

/// Elasticity times thickness in the material axes, N/m, [3, 3], acting on the strain (E00, E11, 2 E01).
Matrix3d plane_stress_elasticity(const Orthotropy& constants, double thickness);

/// Converts an elasticity that acts on strains in the material axes to one that acts on strains in another
/// frame. angle: rad, counterclockwise, from this frame's first axis to the first material axis.
Matrix3d turned_elasticity(const Matrix3d& elasticity, double angle);

/// Angle (rad, counterclockwise) from the first edge of a triangle, x0 to x1, to a direction in its plane.
double axis_angle(const TrianglePositions& rest, const Vector3d& axis);

/// Angle, rad, from the rest edge of a hinge to the first material axis: the mean, modulo 180 degrees, of the
/// angles to the axes of T0 and of T1, each in the plane of its triangle. If the two axes are perpendicular
/// when the hinge is laid flat, the mean is undefined, and the axis of T0 is taken.
double hinge_axis_angle(const HingePositions& rest, const std::array<Vector3d, 2>& axes);

}  // namespace sherd
