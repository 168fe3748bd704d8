// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/check/crack_step_message.h"

#include <fmt/format.h>

#include <cmath>

#include "fracture/cracks/resolving_step.h"

namespace sherd {

std::string crack_step_message(const Scene& scene, const BreakableShell& sheets) {
    const std::optional<double> longest = resolving_step(sheets);
    if (scene.is_static() || !longest) return {};
    const bool by_turns = scene.simulation.alternates;  // cracks then propagate in explicit steps
    const bool is_explicit = by_turns || scene.simulation.stepper.scheme == Scheme::explicit_differences;
    const double step = by_turns ? std::min(scene.simulation.stepper.step, scene.simulation.explicit_step)
                                 : scene.simulation.stepper.step,
                 resolving = round_step(*longest);
    if (step > *longest && is_explicit)
        return fmt::format(
            "one edge a step, slower than their speed limit; solver.step = {:g} lets them reach it",
            resolving);
    if (step > *longest)
        return fmt::format("up to {:.0f} edges a step; solver.step = {:g} resolves them edge by edge",
                           std::ceil(step / *longest), resolving);
    return is_explicit ? ""
                       : fmt::format("one edge a step, as steps of up to {:g} s resolve them", resolving);
}

}  // namespace sherd
