// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "app/scene/toml_table.h"
#include "fracture/simulation.h"

namespace sherd {

/// Reads `box`, `boundary` or `group`; the caller finishes the table.
Selection read_selection(TomlTable& table);

/// Reads the keys pin, clamp and symmetry of a sheet.
void read_supports(TomlTable& table, SheetSpec& sheet);

/// What moves of the vertices that pins and clamps of a sheet hold. Throws Error, naming the scene's line and
/// key, on a vertex of one that moves that another one holds, too.
std::vector<MovingPin> moving_pins(const SheetSpec& sheet, const Mesh& placed);

/// Which of the inputs' vertices, numbered over all inputs, the selection holds; of all sheets, or of the one
/// with this name. Throws Error, naming the scene's line and key, on a group that none of these has.
std::vector<char> selected_vertices(const Selection& selection, const std::string& sheet, const Scene& scene,
                                    const std::vector<SheetInput>& inputs);

/// Adds what clamps and symmetry planes need beyond the pinned vertices of the inputs. mechanics: of all
/// inputs. Throws Error, naming the scene's line and key, on a clamp or a plane that holds no tangent.
void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Sheet& mechanics,
                  SimulationOptions& options);

}  // namespace sherd
