// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// The displacement (m) and the rotation vector (rad) of a rigid body in a step, or their rates.
using Vector6d = Eigen::Matrix<double, 6, 1>;

/// The origins of a rigid body in a step: as in StepContext, but with the body's displacement and rotation
/// since the step's beginning in place of positions.
struct BodyOrigin {
    Vector6d pose = Vector6d::Zero();              ///< m, rad
    Vector6d velocity = Vector6d::Zero();          ///< m/s, rad/s
    Vector3d angular_momentum = Vector3d::Zero();  ///< kg m^2/s
};

/// An implicit time step as energies use it. The time scheme defines the velocity as a function of the
/// positions x at the step's end,
///     v(x) = (x - origin) / lag,
/// and the acceleration, (v(x) - velocity_origin) / lag, at the end of the step. For implicit Euler the
/// origins are the positions and velocities at the beginning, and the lag is the step's length.
struct StepContext {
    double begin = 0;           ///< s
    double length = 0;          ///< s
    double lag = 0;             ///< s
    Positions origin;           ///< [3, V] m
    Positions velocity_origin;  ///< [3, V] m/s
    std::vector<BodyOrigin> bodies;
    double inertia = 1;  ///< share of the masses' inertia that acts: 0 in statics
    double load = 1;     ///< factor of all loads

    void visit_state(StateVisitor& visit) {
        auto& [begin, length, lag, origin, velocity_origin, bodies, inertia, load] = *this;
        visit(begin, length, lag, origin, velocity_origin, bodies, inertia, load);
    }

    double end() const { return begin + length; }  ///< s
    /// lag^2, s^2: a displacement from the inertial prediction, divided by this, is an acceleration.
    double square() const { return lag * lag; }
    /// Velocity v(x), m/s. x: [3, V] m.
    Positions velocity(const Positions& x) const { return (x - origin) / lag; }
    /// Acceleration, m/s^2, for the positions x.
    Positions acceleration(const Positions& x) const { return (velocity(x) - velocity_origin) / lag; }
};

}  // namespace sherd
