// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Returns the numbers of the vertices that the sheet's pins and clamps hold in all directions, in ascending
/// order. Throws Error on one that holds none.
std::vector<std::int32_t> pinned_vertices(const SheetSpec& sheet, const Mesh& placed);

/// Returns how many vertices pins hold that no pin or clamp holds in all directions.
std::size_t partly_pinned_vertices(const SheetSpec& sheet, const Mesh& placed);

/// Returns what moves of the vertices that pins and clamps of a sheet hold. Throws Error, naming the scene's
/// line and key, where a vertex of one that moves is held by another one, too.
std::vector<MovingPin> moving_pins(const SheetSpec& sheet, const Mesh& placed);

/// A pin, clamp or symmetry plane of a sheet, or an obstacle.
struct SupportName {
    std::string name;  ///< as in messages about the scene: "sheet.plate.pin[1]", "obstacle.floor"
    std::string kind;  ///< "pin", "clamp", "symmetry" or "obstacle"
};

/// Returns what has a reaction, in the order of StepReport::reactions: of each sheet the pins, the clamps and
/// the symmetry planes, and then the obstacles.
std::vector<SupportName> support_names(const Scene& scene);

/// Adds what holds which vertices, and what clamps and symmetry planes need beyond the pinned vertices of the
/// inputs. Of several supports of one vertex the first takes the forces in all directions that it holds, the
/// next those in the directions that are left, in the order of support_names(). `mechanics` is that of all
/// inputs. Throws Error, naming the scene's line and key, on a clamp or a plane that holds no tangent.
void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
                  SimulationOptions& options);

}  // namespace sherd
