// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads the key wind of `[force]`, a table or an array of them, into the scene, whose sheets are known.
void read_winds(TomlTable& force, Scene& scene);

}  // namespace sherd
