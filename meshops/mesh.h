// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace sherd {

/// The halfedge mesh: an oriented 2-manifold of triangles, with or without boundary, of any number of
/// components. Vertices, edges and faces are only appended when a crack opens a mesh, so that indices stay
/// valid.
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;

/// Texture coordinates of the three corners of a face, in the order of
/// mesh.vertices_around_face(mesh.halfedge(f)).
using FaceTexture = std::array<Eigen::Vector2d, 3>;

/// Names of the mesh's optional property maps.
namespace property {
inline constexpr const char* texture = "f:texture";  ///< FaceTexture of each face
inline constexpr const char* file_vertex =
    "v:file_vertex";  ///< std::uint32_t, number of the vertex in the file read, from 0
}  // namespace property

}  // namespace sherd
