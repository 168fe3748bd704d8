// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Warns of obstacles and free bodies that no sheet and no other free body can reach: the bounding boxes of
/// sheets and bodies in free flight (velocity, spin, gravity, damping.mass) do not touch that of the
/// obstacle, which moves by its keys. A sheet that is supported or in a wind may move in any direction from
/// the start, and so may a sheet or body that has met anything from then on: at up to three times the largest
/// speed in the scene, so that no warning is wrong. With loads, and in statics, there is no warning. inputs,
/// options: made from the scene, in its order.
void warn_of_unreachable(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings);

}  // namespace sherd
