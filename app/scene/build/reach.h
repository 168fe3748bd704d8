// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Warns of obstacles, free ones included, that no sheet and no other free body can reach: none of the boxes
/// around these comes to the obstacle's while they fly (velocity, spin, gravity, damping.mass) and the
/// obstacle moves by its keys. Whatever is held, is in a wind, or has met anything may go anywhere from then
/// on, three times as fast as anything in the scene, so that no warning is wrong. With loads, and in
/// statics, there is no warning. Inputs and options are those of the scene, in its order.
void warn_of_unreachable(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings);

}  // namespace sherd
