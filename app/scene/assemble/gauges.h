// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Adds the scene's gauges to the options, each at the point of its sheet, or of any sheet if it names none,
/// that is nearest to GaugeSpec::at. mechanics: of all sheets. Throws Error, naming the scene's line and key,
/// if this point is farther away than the longest edge of its face.
void add_gauges(const Scene& scene, const Shell& mechanics, SimulationOptions& options);

}  // namespace sherd
