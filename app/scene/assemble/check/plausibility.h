// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Warns of input that can be computed but is probably a mistake: sheets that are far too large or small for
/// their thickness, such as a mesh that was not scaled; material constants and strengths that no material
/// has; edges that are shorter than the thickness, or so long that a curved sheet locks; steps that are too
/// long for vibrations and motions; positions so far from the origin that round-off matters; caches that do
/// not match the duration; and obstacles that nothing can reach. inputs, options: made from the scene, in its
/// order.
void warn_of_implausible(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings);

/// Returns the period (s) of the slowest bending vibration of a free disc of the sheet's area: omega R^2
/// sqrt(rho h / D) = 5.36 at a Poisson ratio of 0.3 (Leissa, Vibration of Plates, 1969). A curved shell
/// vibrates faster.
double slowest_period(const SheetInput& input);

}  // namespace sherd
