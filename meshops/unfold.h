// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// The faces around a vertex, laid into a plane: the vertex is the origin, sides have their lengths, and the
/// angles are scaled so that they close: by 2 pi over their sum, on the boundary by pi.
struct UnfoldedFan {
    std::vector<Face> faces;              ///< counterclockwise
    std::vector<Vertex> ring;             ///< faces[i] has the corners vertex, ring[i], ring[i + 1]
    std::vector<Eigen::Vector2d> places;  ///< m, places of the ring's vertices
};
/// Unfolds the faces around a vertex. The ring of an interior vertex ends with its first vertex.
UnfoldedFan unfold_fan(const Mesh& mesh, Vertex vertex);

/// The places of source, target and the two opposite corners of the faces at h, unfolded about it: the source
/// is the origin, the target on the x axis, the face of h above it, the opposite one below.
std::array<Eigen::Vector2d, 4> unfold_pair(const Mesh& mesh, Halfedge h);

}  // namespace sherd
