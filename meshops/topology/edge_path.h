// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Returns the edges of `mesh` along the polyline `line` (m), each once, in order. The vertices nearest to
/// the points of the line are joined by shortest paths that keep close to the line, by Dijkstra's algorithm.
/// The cost of an edge is (h + d) l, where l is its length, d the distance of its middle from the line, and h
/// the mean length of all edges. Throws Error, naming points by their number from 0, if a point is farther
/// from its nearest vertex than twice the longest edge at this vertex, if successive points lie on
/// unconnected parts of the mesh, and if the line touches one vertex only.
std::vector<Edge> edge_path(const Mesh& mesh, std::span<const Eigen::Vector3d> line);

}  // namespace sherd
