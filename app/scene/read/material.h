// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/material_axis.h"
#include "app/scene/read/material_presets.h"
#include "app/scene/thickness_map.h"
#include "app/scene/toml/toml_table.h"
#include "core/material/material.h"

namespace sherd {

/// Reads the `axis` of a [material] table; without one it is the mesh's x axis. `directory` is where the
/// names of textures are understood from.
MaterialAxis read_axis(TomlTable& material, const std::filesystem::path& directory);

/// Reads the `thickness` of a [material] table where it is a table; none: it is a number.
std::optional<ThicknessMap> read_thickness_map(TomlTable& material, const std::filesystem::path& directory);

/// Reads the name of a preset; null if there is none.
const MaterialPreset* read_preset(TomlTable& material);

/// Reads the rest of a [material] table and ends it. What a preset (or null) does not give is needed, save
/// Poisson's ratio (0.3). Inadmissible constants are a problem at the key that makes them so. has_map: the
/// thickness has been read, as a map.
Material read_material(TomlTable& table, const MaterialPreset* preset, bool has_map = false);

}  // namespace sherd
