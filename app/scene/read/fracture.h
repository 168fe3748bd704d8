// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/read/material_presets.h"
#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads [sheet.NAME.fracture] of a scene file. `directory` is where the names of files are understood from;
/// material: the preset of the sheet's material, null if it has none.
FractureSpec read_fracture(TomlTable& table, const std::filesystem::path& directory,
                           const MaterialPreset* material);

}  // namespace sherd
