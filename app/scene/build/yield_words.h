// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/yielding.h"

namespace sherd {

/// Whether a sheet keeps what it is bent beyond yield: coupled hinges do in steps that are solved to their
/// end, of sheets whose cracks make no new faces.
bool keeps_bends(const Scene& scene, const SheetSpec& sheet);

/// ShellEnergyOptions::yields.
std::vector<double> kept_yields(const Scene& scene);

/// "1.8 times the yield stress, in sheet.lid at (0.1, 0.02, 0) m at rest".
std::string yield_words(double ratio, const FacePlace& place, const Scene& scene);

}  // namespace sherd
