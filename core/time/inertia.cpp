// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/inertia.h"

#include "core/shell/supports.h"

namespace sherd {

void Inertia::begin(const StepContext& step) {
    Positions displacement = step.lag * step.velocity_origin;
    displacement.colwise() += step.square() * gravity;
    displacement += step.origin - shell.position;
    constrain(shell, displacement);
    per_mass = step.inertia / step.square();
    elements.stiffness = step.inertia * shell.mass / step.square();
    elements.anchor = shell.position + displacement;
    place_scripted(shell, step.end(), elements.anchor);
}

}  // namespace sherd
