// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Returns the numbers of the vertices that the sheet's pins and clamps hold in all directions, in ascending
/// order. Throws Error on one that holds none.
std::vector<std::int32_t> pinned_vertices(const SheetSpec& sheet, const Mesh& placed);

/// Returns what moves of the vertices that pins and clamps of a sheet hold. Throws Error, naming the scene's
/// line and key, where a vertex of one that moves is held by another one, too.
std::vector<MovingPin> moving_pins(const SheetSpec& sheet, const Mesh& placed);

/// Adds what clamps, symmetry planes and pins with free directions need beyond the pinned vertices of the
/// inputs. `mechanics` is that of all inputs. Throws Error, naming the scene's line and key, on a clamp or a
/// plane that holds no tangent.
void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
                  SimulationOptions& options);

}  // namespace sherd
