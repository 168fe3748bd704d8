// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/vector.h"

namespace sherd {

/// Sliding speed, m/s, at which the slip in a step equals Friction::smoothing.
constexpr double smoothing_speed = 0.01;

/// Coulomb friction in one step, with the limit force lagged to its beginning: a potential of the slip
/// (sliding displacement) in the step plus the elastic slip `elastic_slip` from earlier steps, whose slope
/// rises smoothly from zero to the limit. The elastic slip makes contacts stick: below the limit a contact is
/// an elastic bristle (Cundall and Strack 1979), whose force does not need a speed.
struct Friction {
    double limit;                              ///< N, coefficient times normal force
    double smoothing;                          ///< m, slip from which on the force is the limit
    Vector3d elastic_slip = Vector3d::Zero();  ///< m, elastic slip, in the plane of sliding

    double value(const Vector3d& slip) const {  ///< J
        const double way = (elastic_slip + slip).norm(), ratio = way / smoothing;
        return limit * (ratio < 1 ? smoothing * (ratio * ratio - ratio * ratio * ratio / 3 + 1.0 / 3) : way);
    }
    Vector3d gradient(const Vector3d& slip) const {  ///< N
        const double way = (elastic_slip + slip).norm(), ratio = way / smoothing;
        return limit * (elastic_slip + slip) * (ratio < 1 ? (2 - ratio) / smoothing : 1 / way);
    }
    /// Elastic slip for the next step, in multiples of `smoothing`. Its length is at most 1, as in a contact
    /// that slides.
    Vector3d elastic_slip_after(const Vector3d& slip) const {
        const Vector3d whole = (elastic_slip + slip) / smoothing;
        return whole / std::max(1.0, whole.norm());
    }
    /// N/m, positive semidefinite; `tangent` projects to the plane of sliding.
    Matrix3d hessian(const Vector3d& slip_in_step, const Matrix3d& tangent) const {
        const Vector3d slip = elastic_slip + slip_in_step;
        const double way = slip.norm(), ratio = way / smoothing;
        // d(f(w) u/w)/du = f/w (I - uu/w2) + f' uu/w2, both parts positive.
        const double across = ratio < 1 ? (2 - ratio) / smoothing : 1 / way;
        const double along = ratio < 1 ? 2 * (1 - ratio) / smoothing : 0;
        Matrix3d block = across * tangent;
        if (way > 0) block += (along - across) / (way * way) * slip * slip.transpose();
        return limit * block;
    }
};

/// The force, N, of Coulomb friction in an explicit step of `length` s on an effective mass (kg) that slides
/// at `velocity` (m/s): it stops the sliding, but never reverses it. limit: N.
inline Vector3d explicit_friction(double limit, const Vector3d& velocity, double mass, double length) {
    const double speed = velocity.norm();
    return speed > 0 ? Vector3d(-std::min(limit / speed, mass / length) * velocity) : Vector3d::Zero();
}

}  // namespace sherd
