// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/hinge.h"

namespace sherd {

/// A bending energy with a quadratic and a cubic part in the positions of four vertices,
///     E = 1/2 sum_c x_c^T Q x_c - k [e0, e1, e2] + constant,
/// where x_c are the coordinates c of the vertices. It equals the energy of the nonlinear hinge (paper, eq.
/// 4) along isometric deformations.
struct CubicHinge {
    Eigen::Matrix4d quadratic;  ///< Q, N/m, the same for x, y and z; rows sum to zero
    double cubic = 0;           ///< k, N/m^2
    double constant = 0;        ///< J, makes E = 0 at rest
};

/// The hinge of the paper's eq. 7, with the factor that its printed k lacks. It has a force at rest unless
/// the rest angle is zero, and Q is negative semidefinite for rest angles beyond a right angle. rest: m;
/// stiffness: lambda in N m.
CubicHinge cubic_hinge_2007(const HingePositions& rest, double stiffness);

/// The cubic hinge in equilibrium at rest: eq. 7 less multiples of the squares of the five edge lengths that
/// cancel its force at rest. The correction is constant under isometry and changes only Q, which becomes
/// positive semidefinite. rest: m; stiffness: lambda in N m (D / 3 for a plate of rigidity D).
CubicHinge cubic_hinge(const HingePositions& rest, double stiffness);

/// Energy, J.
double value(const CubicHinge& hinge, const HingePositions& x);
/// Bound on the round-off error of the energy, J.
double round_off(const CubicHinge& hinge);
/// dE/dx, N, [3, 4].
HingePositions gradient(const CubicHinge& hinge, const HingePositions& x);
/// d2E/dx2, N/m, [12, 12], coordinate fastest (appendix A; the paper's CS). If `cubic_part` is false, the
/// result is only the part of Q, which is constant (the paper's CC).
HingeHessian hessian(const CubicHinge& hinge, const HingePositions& x, bool cubic_part = true);

}  // namespace sherd
