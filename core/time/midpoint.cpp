// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/midpoint.h"

#include "core/contact/bodies/body_potential.h"

namespace sherd {

StepContext Midpoint::begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                            double length) {
    StepContext step{time, length, length, shell.position, shell.velocity, {}};
    step.where = 0.5;
    for (const RigidBody& body : bodies) {
        // The spin in the middle of the step, with the axes there.
        RigidBody halfway = body;
        halfway.rotation = turned(0.5 * length * body.spin()) * body.rotation;
        BodyOrigin origin;
        origin.velocity << body.velocity, halfway.spin();
        origin.angular_momentum = body.angular_momentum;
        step.bodies.push_back(origin);
    }
    return step;
}

void Midpoint::topology_changed(const Shell& shell, const ShellChange&, StepContext& step) {
    step.origin = shell.position;
    step.velocity_origin = shell.velocity;
}

void Midpoint::finish(const StepContext& step, const Positions& x, Shell& shell) {
    shell.velocity = step.end_velocity(x);
    shell.position = x;
}

}  // namespace sherd
