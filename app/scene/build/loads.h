// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Adds the scene's loads to the options. `mechanics` has all inputs. Throws Error, naming the scene's line
/// and key, on a load that acts on nothing.
void add_loads(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
               SimulationOptions& options);

}  // namespace sherd
