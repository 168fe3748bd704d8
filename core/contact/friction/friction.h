// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/vector.h"

namespace sherd {

/// Sliding speed, m/s, at which the slip in one step equals Friction::smoothing.
constexpr double smoothing_speed = 0.01;

/// Coulomb friction in one step, with a limit force that is computed at the beginning of the step. Friction
/// is a potential of the slip (sliding displacement) in the step plus the elastic slip `elastic_slip` from
/// earlier steps; the slope of the potential rises smoothly from zero to the limit. The elastic slip makes
/// contacts stick: below the limit a contact is an elastic bristle (Cundall and Strack 1979), whose force
/// does not need a speed.
struct Friction {
    double limit;                              ///< N, limit force: friction coefficient times normal force
    double smoothing;                          ///< m, slip at and above which the force equals the limit
    Vector3d elastic_slip = Vector3d::Zero();  ///< m, in the plane of sliding

    double value(const Vector3d& slip) const {  ///< J
        const double way = (elastic_slip + slip).norm(), ratio = way / smoothing;
        return limit * (ratio < 1 ? smoothing * (ratio * ratio - ratio * ratio * ratio / 3 + 1.0 / 3) : way);
    }
    Vector3d gradient(const Vector3d& slip) const {  ///< N; the force is its negative
        const double way = (elastic_slip + slip).norm(), ratio = way / smoothing;
        return limit * (elastic_slip + slip) * (ratio < 1 ? (2 - ratio) / smoothing : 1 / way);
    }
    /// Elastic slip for the next step, in multiples of `smoothing`. Its length is at most 1, the length in a
    /// contact that slides.
    Vector3d elastic_slip_after(const Vector3d& slip) const {
        const Vector3d whole = (elastic_slip + slip) / smoothing;
        return whole / std::max(1.0, whole.norm());
    }
    /// Second derivative of value(), N/m, positive semidefinite. `tangent` is the projection to the plane of
    /// sliding.
    Matrix3d hessian(const Vector3d& slip_in_step, const Matrix3d& tangent) const {
        const Vector3d slip = elastic_slip + slip_in_step;
        const double way = slip.norm(), ratio = way / smoothing;
        // With slip u, w = |u| and force f(w): d(f u/w)/du = f/w (I - uu/w2) + f' uu/w2, where both terms are
        // positive semidefinite.
        const double across = ratio < 1 ? (2 - ratio) / smoothing : 1 / way;
        const double along = ratio < 1 ? 2 * (1 - ratio) / smoothing : 0;
        Matrix3d block = across * tangent;
        if (way > 0) block += (along - across) / (way * way) * slip * slip.transpose();
        return limit * block;
    }
};

/// The force, N, of Coulomb friction in an explicit step of `length` (s) on a contact of effective mass
/// `mass` (kg) that slides at `velocity` (m/s). The force, at most `limit` (N), may stop the sliding, but
/// never reverses it.
inline Vector3d explicit_friction(double limit, const Vector3d& velocity, double mass, double length) {
    const double speed = velocity.norm();
    return speed > 0 ? Vector3d(-std::min(limit / speed, mass / length) * velocity) : Vector3d::Zero();
}

}  // namespace sherd
