// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Adds the scene's gauges, each at the point of the mechanics of all sheets that is nearest to its place.
/// Throws Error, naming the scene's line and key, on a gauge that is farther from its sheet than the longest
/// edge of the face there.
void add_gauges(const Scene& scene, const Shell& mechanics, SimulationOptions& options);

}  // namespace sherd
