// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads the keys pin, clamp and symmetry of a sheet.
void read_supports(TomlTable& table, SheetSpec& sheet);

}  // namespace sherd
