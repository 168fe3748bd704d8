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

void BodyInertia::begin(const StepContext& step) {
    if (!bodies) return;
    elements.first = bodies->first_column(0);
    elements.anchor.resize(3, bodies->place().cols());
    elements.stiffness.resize(elements.anchor.cols());
    for (std::size_t b = 0; b < bodies->bodies().size(); ++b) {
        const auto column = static_cast<Eigen::Index>(2 * b);
        elements.anchor.middleCols<2>(column) = bodies->prediction(b);
        elements.stiffness.segment<2>(column).setConstant(bodies->bodies()[b].mass / step.square());
    }
}

}  // namespace sherd
