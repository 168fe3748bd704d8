// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/mesh.h"

namespace sherd {

/// Whether a selection contains a vertex. A selection without box, boundary and group contains all vertices.
bool selects(const Selection& selection, const Mesh& placed, Vertex v);

/// Throws Error, naming the scene's line and key, if the selection has a group that is not in `known`, the
/// names of the groups of the meshes from which it selects.
void check_group(const Selection& selection, const std::vector<std::string>& known);

/// Returns, for each vertex of all inputs, whether it is selected. Vertices are selected from the sheet with
/// the name `sheet`, or from all sheets if `sheet` is empty. Throws Error, naming the scene's line and key,
/// on a group that none of these sheets has.
std::vector<char> selected_vertices(const Selection& selection, const std::string& sheet, const Scene& scene,
                                    const std::vector<SheetInput>& inputs);

}  // namespace sherd
