// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/inertia.h"

#include "core/shell/supports.h"

namespace sherd {

void Inertia::begin(const StepContext& step) {
    Positions displacement = step.lag * step.velocity_origin;
    displacement.colwise() += step.lag * step.lag * gravity;
    displacement += step.origin - sheet.position;
    constrain(sheet, displacement);
    elements.stiffness = sheet.mass / (step.lag * step.lag);
    elements.anchor = sheet.position + displacement;
    place_carried(sheet, step.end(), elements.anchor);
}

}  // namespace sherd
