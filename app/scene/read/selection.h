// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads `box`, `boundary` or `group`. The caller finishes the table.
Selection read_selection(TomlTable& table);

}  // namespace sherd
