// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reports what a static scene cannot have: what moves or acts with time, and sheets that nothing holds.
void require_statics(TomlTable& root, const Scene& scene);

}  // namespace sherd
