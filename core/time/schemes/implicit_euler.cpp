// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/schemes/implicit_euler.h"

namespace sherd {

StepContext ImplicitEuler::begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                                 double length) {
    StepContext step{time, length, length, shell.position, shell.velocity, {}};
    for (const RigidBody& body : bodies) {
        BodyOrigin origin;
        origin.velocity << body.velocity, body.spin();
        origin.angular_momentum = body.angular_momentum;
        step.bodies.push_back(origin);
    }
    return step;
}

void ImplicitEuler::topology_changed(const Shell& shell, const ShellChange&, StepContext& step) {
    step.origin = shell.position;
    step.velocity_origin = shell.velocity;
}

void ImplicitEuler::finish(const StepContext& step, const Positions& x, Shell& shell) {
    shell.velocity = step.velocity(x);
    shell.position = x;
}

}  // namespace sherd
