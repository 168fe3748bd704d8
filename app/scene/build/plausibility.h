// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Warns of what can be computed but is hardly meant: sheets that are far too large or small for their
/// thickness, as of a mesh that was never scaled; thresholds that no material has; edges that are shorter
/// than the sheet is thick, or so long that a curved sheet locks; what goes farther in a step than it should;
/// places so far from the origin that their digits
/// run out; and obstacles that nothing can reach. Inputs and options are those of the scene, in its order.
void warn_of_implausible(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings);

/// Returns the period (s) of the slowest bending vibration of a free disc of the sheet's area: omega R^2
/// sqrt(rho h / D) = 5.36 at a Poisson ratio of 0.3 (Leissa, Vibration of Plates, 1969). A curved shell
/// vibrates faster.
double slowest_period(const SheetInput& input);

}  // namespace sherd
