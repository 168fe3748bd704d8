// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/record/yielding.h"

namespace sherd {

/// Whether a sheet bends plastically beyond its yield stress. This requires a yield stress, coupled hinges, a
/// scheme whose elastic forces act at the end of a step, and no toughness, since cracks by toughness insert
/// faces.
bool bends_plastically(const Scene& scene, const SheetSpec& sheet);

/// Returns ShellEnergyOptions::yields for a scene: the yield stress of each sheet that bends plastically.
std::vector<double> plastic_yields(const Scene& scene);

/// Returns, for example, "1.8 times the yield stress, in sheet.lid at (0.1, 0.02, 0) m at rest".
std::string yield_message(double ratio, const FacePlace& place, const Scene& scene);

}  // namespace sherd
