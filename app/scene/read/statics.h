// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reports parts of a scene that statics do not allow: velocities, free bodies, wind, damping, ramps of
/// loads, and sheets without supports; with arc_length also prescribed motions and the lack of a load.
void require_statics(TomlTable& root, const Scene& scene);

}  // namespace sherd
