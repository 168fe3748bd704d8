// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "meshops/mesh.h"

namespace sherd {

/// The mesh of triangles given as plain arrays. positions: [V] m; triangles: [F] three vertices each,
/// numbered from 0 and counterclockwise seen from where the normal points to. Vertices and faces keep their
/// numbers. Throws Error naming the vertex or the face on: no triangle, a coordinate that is not finite, a
/// vertex that does not exist or that no face uses, a triangle without area or given twice, an edge of three
/// or more faces, neighbours whose normals disagree, a surface with one side only, and faces that meet in a
/// vertex without being joined by an edge.
Mesh triangle_mesh(std::span<const Eigen::Vector3d> positions,
                   std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace sherd
