// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/mesh.h"

namespace sherd {

/// Whether a selection contains a vertex. A selection without box, boundary and group contains all.
bool selects(const Selection& selection, const Mesh& placed, Vertex v);

/// Throws Error, naming the scene's line and key, if the selection's group is none of `known`, the groups of
/// the meshes that it selects from.
void check_group(const Selection& selection, const std::vector<std::string>& known);

/// Flags of the inputs' vertices, numbered over all inputs, that are selected: of all sheets, or of the sheet
/// with this name. Throws Error, naming the scene's line and key, on a group that none of these sheets has.
std::vector<char> selected_vertices(const Selection& selection, const std::string& sheet, const Scene& scene,
                                    const std::vector<SheetInput>& inputs);

}  // namespace sherd
