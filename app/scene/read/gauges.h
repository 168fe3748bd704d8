// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads `[[gauge]]` of the scene's root, after its sheets.
void read_gauges(TomlTable& root, Scene& scene);

}  // namespace sherd
