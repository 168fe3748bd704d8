// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/obstacle_spec.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads `[obstacle.NAME]`. Files are named relative to `directory`.
ObstacleSpec read_obstacle(const std::string& name, TomlTable& table, const std::filesystem::path& directory);

}  // namespace sherd
