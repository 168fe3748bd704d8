// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "fracture/toughness.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns what the hinges of a sheet that breaks withstand: its strength, and for each edge of `placed` the
/// product of the factors of the scatter, which comes from the scene's seed, of the maps and of the scores of
/// the strength; infinite where it never breaks. Throws Error naming the scene's line and key; warnings are
/// sentences.
Strength sheet_strength(const SheetSpec& sheet, const Scene& scene, const Mesh& placed,
                        std::vector<std::string>& warnings);

/// The toughness of a sheet that breaks, with the factors of the maps and of the scores of the toughness, and
/// the speed limit of its material unless one is given. Throws as sheet_strength() does.
Toughness sheet_toughness(const SheetSpec& sheet, const Mesh& placed, std::vector<std::string>& warnings);

}  // namespace sherd
