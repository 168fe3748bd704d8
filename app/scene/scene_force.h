// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml_table.h"
#include "fracture/simulation.h"

namespace sherd {

/// Reads [force]: gravity and loads. The sheets must have been read.
void read_forces(TomlTable& table, Scene& scene);

/// Adds the scene's loads. mechanics: of all inputs. Throws Error, naming the scene's line and key, on a load
/// that acts on nothing.
void add_loads(const Scene& scene, const std::vector<SheetInput>& inputs, const Sheet& mechanics,
               SimulationOptions& options);

}  // namespace sherd
