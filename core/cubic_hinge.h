// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/hinge.h"

namespace sherd {

/// The cubic hinge in equilibrium at rest: an energy quadratic plus cubic in the positions of four vertices,
///     E = 1/2 sum_c x_c^T Q x_c - k [e0, e1, e2] + constant,
/// equal to the nonlinear hinge (eq. 4) along isometric deformations. Eq. 7 of the paper has a force at rest
/// wherever the rest angle is not zero; subtracting multiples of the squared edge lengths removes it,
/// vanishes under isometry, and only changes Q (which becomes positive semidefinite).
struct CubicHinge {
    Eigen::Matrix4d quadratic;  ///< Q, N/m, the same for x, y and z; rows sum to zero
    double cubic = 0;           ///< k, N/m^2
    double constant = 0;        ///< J, makes E = 0 at rest
};

/// stiffness: lambda in N m (D / 3 for a plate of rigidity D).
CubicHinge cubic_hinge(const HingePositions& rest, double stiffness);

/// Value, J.
double value(const CubicHinge& hinge, const HingePositions& x);
/// dE/dx, N, [3, 4].
HingePositions gradient(const CubicHinge& hinge, const HingePositions& x);
/// d2E/dx2, N/m, [12, 12], coordinate fastest (appendix A). `cubic_part = false` leaves the positive
/// semidefinite Q alone.
Eigen::Matrix<double, 12, 12> hessian(const CubicHinge& hinge, const HingePositions& x,
                                      bool cubic_part = true);

}  // namespace sherd
