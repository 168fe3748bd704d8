// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/implicit_euler.h"

namespace sherd {

StepContext ImplicitEuler::begin(const Sheet& sheet, const std::vector<RigidBody>& bodies, double time,
                                 double length) const {
    StepContext step{time, length, length, sheet.position, sheet.velocity, {}};
    for (const RigidBody& body : bodies) {
        BodyOrigin origin;
        origin.velocity << body.velocity, body.spin();
        step.bodies.push_back(origin);
    }
    return step;
}

void ImplicitEuler::topology_changed(const Sheet& sheet, const ShellChange&, StepContext& step) {
    step.origin = sheet.position;
    step.velocity_origin = sheet.velocity;
}

void ImplicitEuler::finish(const StepContext& step, const Positions& x, Sheet& sheet) {
    sheet.velocity = step.velocity(x);
    sheet.position = x;
}

}  // namespace sherd
