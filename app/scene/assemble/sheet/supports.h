// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Returns the numbers of the vertices that the sheet's pins and clamps hold in all directions, in ascending
/// order. Throws Error on a pin or clamp that holds no vertex.
std::vector<std::int32_t> pinned_vertices(const SheetSpec& sheet, const Mesh& placed);

/// Returns the number of vertices that pins hold in some directions, and that no pin or clamp holds in all
/// directions.
std::size_t partly_pinned_vertices(const SheetSpec& sheet, const Mesh& placed);

/// Returns the moving pins and clamps of a sheet. Throws Error, naming the scene's line and key, if a vertex
/// is held by two pins or clamps of which at least one moves.
std::vector<MovingPin> moving_pins(const SheetSpec& sheet, const Mesh& placed);

/// A pin, clamp or symmetry plane of a sheet, or an obstacle.
struct SupportName {
    std::string name;  ///< as in messages about the scene: "sheet.plate.pin[1]", "obstacle.floor"
    std::string kind;  ///< "pin", "clamp", "symmetry" or "obstacle"
};

/// Returns the names of all supports and obstacles, in the order of StepReport::reactions: pins, clamps and
/// symmetry planes of each sheet, then the obstacles.
std::vector<SupportName> support_names(const Scene& scene);

/// Adds the held vertices with their supports, and mirror hinges for clamps and symmetry planes, to the
/// options. If several supports hold a vertex, the first one in the order of support_names() takes the forces
/// in all directions that it holds, and each later one takes the forces in directions that it adds.
/// mechanics: of all inputs. Throws Error, naming the scene's line and key, on a clamp that holds neither an
/// edge of the boundary nor a face, and on a symmetry plane without an edge of the boundary.
void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
                  SimulationOptions& options);

}  // namespace sherd
