// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Warns of obstacles, free bodies included, that no sheet and no other free body can reach: none of their
/// bounding boxes touches the obstacle's while they fly (velocity, spin, gravity, damping.mass) and the
/// obstacle moves by its keys. Sheets and bodies that are supported, in a wind, or have met anything, may
/// move in any direction from then on, at three times the largest speed in the scene, so that no warning is
/// wrong. With loads, and in statics, there is no warning. Inputs and options are those of the scene, in its
/// order.
void warn_of_unreachable(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings);

}  // namespace sherd
