// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/hinge.h"

namespace sherd {

/// The nonlinear hinge (paper, eqs. 3 and 4, without the assumption of isometry):
///     E = lambda 3 |e0bar|^2 / Abar (1 - cos(theta - thetabar)),
/// with the true dihedral angle theta, on any deformation. A bar marks quantities of the rest shape.
struct NonlinearHinge {
    double scale = 0;                        ///< lambda 3 |e0bar|^2 / Abar, J
    Vector2d rest_turn = Vector2d::UnitX();  ///< cos and sin of the rest angle
};

/// The nonlinear hinge from its rest shape. rest: m; stiffness: lambda in N m (D / 3 for a plate of rigidity
/// D).
NonlinearHinge nonlinear_hinge(const HingePositions& rest, double stiffness);

/// Energy, J. The energy and its derivatives are NaN if a triangle has no area.
double value(const NonlinearHinge& hinge, const HingePositions& x);
/// Bound on the round-off error of the energy, J.
double round_off(const NonlinearHinge& hinge);
/// dE/dx, N, [3, 4].
HingePositions gradient(const NonlinearHinge& hinge, const HingePositions& x);
/// d2E/dx2, N/m, [12, 12], coordinate fastest, in closed form. `convex` leaves only the positive semidefinite
/// part max(cos(theta - thetabar), 0) grad theta grad theta^T.
HingeHessian hessian(const NonlinearHinge& hinge, const HingePositions& x, bool convex = false);

}  // namespace sherd
