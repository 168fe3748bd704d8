// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads [sheet.NAME] of a scene file in `directory`, from which the names of mesh files are understood.
SheetSpec read_sheet(const std::string& name, TomlTable& table, const std::filesystem::path& directory);

}  // namespace sherd
