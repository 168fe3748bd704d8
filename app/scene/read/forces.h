// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads [force]: gravity, loads and wind. The sheets must have been read.
void read_forces(TomlTable& table, Scene& scene);

}  // namespace sherd
