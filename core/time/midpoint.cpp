// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/midpoint.h"

#include "core/contact/bodies/body_potential.h"

namespace sherd {

StepContext Midpoint::begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                            double length) {
    StepContext step = euler.begin(shell, bodies, time, length);
    step.where = 0.5;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        // The spin in the middle of the step, with the axes there.
        RigidBody halfway = bodies[b];
        halfway.rotation = turned(0.5 * length * halfway.spin()) * halfway.rotation;
        step.bodies[b].velocity.tail<3>() = halfway.spin();
    }
    return step;
}

}  // namespace sherd
