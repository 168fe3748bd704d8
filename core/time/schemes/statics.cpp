// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/schemes/statics.h"

namespace sherd {

StepContext Statics::begin(const Shell& shell, const std::vector<RigidBody>&, double time, double length) {
    StepContext step{time, length, length, shell.position, {}, {}, 0, time + length};
    step.velocity_origin = Positions::Zero(3, shell.position.cols());
    return step;
}

void Statics::topology_changed(const Shell& shell, const ShellChange&, StepContext& step) {
    step.origin = shell.position;
    step.velocity_origin = Positions::Zero(3, shell.position.cols());
}

void Statics::finish(const StepContext&, const Positions& x, Shell& shell) {
    shell.velocity.setZero();
    shell.position = x;
}

}  // namespace sherd
