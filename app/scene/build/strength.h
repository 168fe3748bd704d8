// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "fracture/toughness.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the strength of a sheet that can fail. The factor of each edge of `placed` is the product of those
/// of the scatter (with the scene's seed), of the maps and of the scores of the strength; infinite where it
/// never fails. Throws Error naming the scene's line and key; warnings are sentences.
Strength sheet_strength(const SheetSpec& sheet, const Scene& scene, const Mesh& placed,
                        std::vector<std::string>& warnings);

/// The toughness of a sheet that can fail, with the factors of the maps and of the scores of the toughness,
/// and the speed limit of its material unless one is given. Throws Error like sheet_strength().
Toughness sheet_toughness(const SheetSpec& sheet, const Mesh& placed, std::vector<std::string>& warnings);

}  // namespace sherd
