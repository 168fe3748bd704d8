// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/mesh.h"

namespace sherd {

/// Returns the mesh of triangles given as plain arrays. positions: [V] m; triangles: [F] three vertices each,
/// numbered from 0, counterclockwise seen from the side to which the normal points. Vertices and faces keep
/// their numbers. Throws Error, naming the vertex or the face, if there is no triangle; if a coordinate is
/// not finite; if a triangle names a vertex that does not exist; if no face uses a vertex; if a triangle has
/// no area or is given twice; if three or more faces meet at an edge; if the normals of neighbours disagree;
/// if a surface has only one side; and if faces meet in a vertex without being joined by an edge.
Mesh triangle_mesh(std::span<const Eigen::Vector3d> positions,
                   std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace sherd
