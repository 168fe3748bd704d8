// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "app/scene/scene.h"
#include "app/scene/strength_map.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the scored edges, each once. Throws Error, naming the scene's line and key, on a list of edges for
/// a mesh that is not as in its file, and like read_edge_list() and edge_path().
std::vector<Edge> scored_edges(const Score& score, const Mesh& placed, const Eigen::Isometry3d& place);

/// The edges of the cracks that sheets have from the start, numbered over all inputs, ascending. Throws Error
/// like scored_edges(), and on an edge of the boundary.
std::vector<Edge> cracked_edges(const Scene& scene, const std::vector<SheetInput>& inputs);

}  // namespace sherd
