// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads the key sheet of a load or a wind; the name is empty when the key is missing. The scene's sheets
/// must have been read.
std::string read_sheet_name(TomlTable& table, const Scene& scene);

}  // namespace sherd
