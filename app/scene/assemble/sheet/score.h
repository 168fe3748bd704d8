// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "app/scene/scene.h"
#include "app/scene/strength_map.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the edges of a scored line or of a crack, each once. placed: mesh of the sheet where the scene
/// places it; place: its placement. Throws Error, naming the scene's line and key, on a list of edges for a
/// mesh that is not as in its file, and like read_edge_list() and edge_path().
std::vector<Edge> scored_edges(const Score& score, const Mesh& placed, const Eigen::Isometry3d& place);

/// Returns the edges of all initial cracks, numbered over the meshes of all inputs, in ascending order.
/// Throws Error like scored_edges(), and on an edge of the boundary.
std::vector<Edge> cracked_edges(const Scene& scene, const std::vector<SheetInput>& inputs);

}  // namespace sherd
