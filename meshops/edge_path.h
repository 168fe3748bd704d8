// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Edges of `mesh` along a polyline (m), each once, in order: its points' nearest vertices, joined by
/// connected paths that are as short as they can be while they keep close to the line, by Dijkstra's
/// algorithm with the cost (h + d) l of an edge of length l whose middle is d away from the line, h being the
/// mean edge length. Throws Error, naming points by their number from 0: on one that is farther from its
/// nearest vertex than two of the edges there, on two neighbours on parts of the mesh that are not connected,
/// and on a line that touches one vertex only.
std::vector<Edge> edge_path(const Mesh& mesh, std::span<const Eigen::Vector3d> line);

}  // namespace sherd
