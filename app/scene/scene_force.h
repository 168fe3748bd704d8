// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml_table.h"
#include "fracture/simulation.h"

namespace sherd {

/// Reads [force]: gravity, loads and wind. The sheets must have been read.
void read_forces(TomlTable& table, Scene& scene);

/// Reads the key sheet of a load or a wind; empty when it is missing.
std::string read_sheet_name(TomlTable& table, const Scene& scene);

/// Adds the scene's loads. mechanics: of all inputs. Throws Error, naming the scene's line and key, on a load
/// that acts on nothing.
void add_loads(const Scene& scene, const std::vector<SheetInput>& inputs, const Sheet& mechanics,
               SimulationOptions& options);

}  // namespace sherd
