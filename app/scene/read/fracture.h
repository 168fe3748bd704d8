// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads [sheet.NAME.fracture] of a scene file. `directory` is where the names of files are understood from.
FractureSpec read_fracture(TomlTable& table, const std::filesystem::path& directory);

}  // namespace sherd
