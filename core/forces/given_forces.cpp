// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/given_forces.h"

#include "core/shell/inheritance.h"

namespace sherd {

void GivenForces::give(const Positions& forces) {
    acceleration = forces * shell.mass.cwiseInverse().asDiagonal();
}

void GivenForces::begin(const StepContext& step) {
    start = shell.position;
    force = step.load * acceleration * shell.mass.asDiagonal();
}

void GivenForces::topology_changed(const ShellChange& change, const StepContext& step) {
    follow(acceleration, change);
    begin(step);
}

double GivenForces::value(const Positions& x) const {
    return -force.cwiseProduct(x - start).sum();
}

void GivenForces::add_gradient(const Positions& /*x*/, Positions& gradient) const {
    gradient -= force;
}

}  // namespace sherd
