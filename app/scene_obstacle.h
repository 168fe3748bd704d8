// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene.h"
#include "app/toml_table.h"
#include "core/contact/obstacle.h"

namespace sherd {

/// Reads `[obstacle.NAME]`.
ObstacleSpec read_obstacle(const std::string& name, TomlTable& table);

/// The scene's obstacles, in its order.
std::vector<Obstacle> make_obstacles(const Scene& scene);

}  // namespace sherd
