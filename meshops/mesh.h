// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace sherd {

/// The halfedge mesh: an oriented 2-manifold of triangles, with or without boundary, of any number of
/// components. When a crack opens a mesh, vertices, edges and faces are only appended, so that indices stay
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

/// Converts the result of Mesh::property_map(), which is a pair in CGAL 5 and an optional in CGAL 6, to a
/// pair.
template <class Map>
std::pair<Map, bool> found_property(const std::pair<Map, bool>& answer) {
    return answer;
}
template <class Map>
std::pair<Map, bool> found_property(const std::optional<Map>& answer) {
    return {answer.value_or(Map()), answer.has_value()};
}

/// Returns the property map `name` of the mesh and whether it exists; if not, the map is not valid.
template <class Element, class Value>
std::pair<Mesh::Property_map<Element, Value>, bool> find_property(const Mesh& mesh, const char* name) {
    return found_property(mesh.property_map<Element, Value>(name));
}

}  // namespace sherd
