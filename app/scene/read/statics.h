// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

/// Reads the keys of [solver] that choose between time and load, and the length of a step.
void read_scheme(TomlTable& table, SolverSpec& solver);

/// Reports what a static scene cannot have: what moves or acts with time, and sheets that nothing holds.
void require_statics(TomlTable& root, const Scene& scene);

}  // namespace sherd
