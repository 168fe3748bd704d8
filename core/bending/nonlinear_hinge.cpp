// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/nonlinear_hinge.h"

#include <algorithm>
#include <limits>

#include "core/elements/dihedral_angle.h"

namespace sherd {
namespace {

using HingeVector = Eigen::Matrix<double, 12, 1>;

/// cos and sin of theta - thetabar. turn: cos and sin of theta.
Vector2d turn_from_rest(const NonlinearHinge& hinge, const Vector2d& turn) {
    const Vector2d& rest = hinge.rest_turn;
    return {turn.dot(rest), turn[1] * rest[0] - turn[0] * rest[1]};
}

}  // namespace

NonlinearHinge nonlinear_hinge(const HingePositions& rest, double stiffness) {
    const RestHinge geometry = rest_hinge(rest);
    NonlinearHinge hinge;
    hinge.scale = 3 * stiffness * geometry.edge_length * geometry.edge_length / geometry.area;
    hinge.rest_turn = DihedralAngle(rest).turn();
    return hinge;
}

double value(const NonlinearHinge& hinge, const HingePositions& x) {
    // Equals 1 - cos(theta - thetabar), without its cancellation.
    return 0.5 * hinge.scale * (DihedralAngle(x).turn() - hinge.rest_turn).squaredNorm();
}

double round_off(const NonlinearHinge& hinge) {
    return 4 * std::numeric_limits<double>::epsilon() * hinge.scale;
}

HingePositions gradient(const NonlinearHinge& hinge, const HingePositions& x) {
    const DihedralAngle angle(x);
    return hinge.scale * turn_from_rest(hinge, angle.turn())[1] * angle.gradient();
}

HingeHessian hessian(const NonlinearHinge& hinge, const HingePositions& x, bool convex) {
    const DihedralAngle angle(x);
    const Vector2d turn = hinge.scale * turn_from_rest(hinge, angle.turn());
    const HingeVector slope = angle.gradient().reshaped();
    HingeHessian h = (convex ? std::max(turn[0], 0.0) : turn[0]) * slope * slope.transpose();
    if (!convex) angle.add_hessian(turn[1], h);
    return h;
}

}  // namespace sherd
