// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene.h"
#include "app/toml_table.h"

namespace sherd {

/// Reads [sheet.NAME] of a scene file in `directory`, from which the names of mesh files are understood.
SheetSpec read_sheet(const std::string& name, TomlTable& table, const std::filesystem::path& directory);

/// Reads a [material] table to its end: what a preset does not give is needed, save Poisson's ratio (0.3).
Material read_material(TomlTable& table);

}  // namespace sherd
