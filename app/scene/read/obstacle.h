// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "app/scene/obstacle_spec.h"

namespace sherd {

extern const Section<ObstacleSpec> obstacle_section;  ///< `[obstacle.NAME]`

/// Whether the table of an obstacle has a key that gives its shape.
bool has_shape(TomlTable& table);

}  // namespace sherd
