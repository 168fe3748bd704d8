// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// A sheet of a scene, ready to be simulated. Throws Error naming the scene's line and key, also when the
/// sheet is too thick for its mesh to hold its shape; warnings are sentences.
SheetInput make_sheet(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings);

/// inputs: of all sheets, in the scene's order. Throws Error naming the scene's line and key of a load or
/// support that reaches nothing, of an obstacle that cannot be made, and of one that a sheet starts in. That
/// the sheets start apart is for part_sheets() to see.
SimulationOptions simulation_options(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     std::vector<std::string>& warnings);

}  // namespace sherd
