// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "app/scene/scene.h"
#include "app/scene/score.h"
#include "fracture/breakable_shell.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns the edges that are scored, each once. Throws Error, naming the scene's line and key, on a list of
/// edges for a mesh that is not as in its file, and on what read_edge_list and edge_path throw on.
std::vector<Edge> scored_edges(const Score& score, const Mesh& placed, const Eigen::Isometry3d& place);

/// The edges of the cracks that sheets have from the start, numbered over all inputs, ascending. Throws Error
/// as scored_edges() does, and on an edge of the rim.
std::vector<Edge> cracked_edges(const Scene& scene, const std::vector<SheetInput>& inputs);

}  // namespace sherd
