// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// What the hinges of a sheet that breaks withstand: its strength, and for each edge of `placed` the factor
/// of the scatter, which comes from the scene's seed.
Strength sheet_strength(const SheetSpec& sheet, const Scene& scene, const Mesh& placed);

}  // namespace sherd
