// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "meshops/mesh.h"

namespace sherd {

/// Returns a face that has all of `vertices`, which are one, two or three; the null face if there is none.
inline Face face_with(const Mesh& mesh, std::span<const std::int32_t> vertices) {
    for (const Face face : mesh.faces_around_target(mesh.halfedge(Vertex(vertices.front())))) {
        if (face == Mesh::null_face()) continue;
        const auto corners = mesh.vertices_around_face(mesh.halfedge(face));
        if (std::all_of(vertices.begin(), vertices.end(), [&](std::int32_t vertex) {
                return std::find(corners.begin(), corners.end(), Vertex(vertex)) != corners.end();
            }))
            return face;
    }
    return Mesh::null_face();
}

inline Eigen::Vector3d position(const Mesh& mesh, Vertex v) {
    const Point& p = mesh.point(v);
    return {p.x(), p.y(), p.z()};
}

inline Point point_at(const Eigen::Vector3d& place) {
    return {place.x(), place.y(), place.z()};
}

Eigen::Vector3d centroid(const Mesh& mesh, Face face);  ///< m
double face_area(const Mesh& mesh, Face face);          ///< m^2
/// The corners of a face, in the order of mesh.vertices_around_face(mesh.halfedge(face)).
std::array<Vertex, 3> face_corners(const Mesh& mesh, Face face);
/// Index of a vertex among the corners of a face; 3 if it is none of them.
inline std::size_t corner_number(const std::array<Vertex, 3>& corners, Vertex vertex) {
    return std::find(corners.begin(), corners.end(), vertex) - corners.begin();
}
std::array<Eigen::Vector3d, 3> face_points(const Mesh& mesh, Face face);  ///< positions of face_corners(), m
/// Twice the area of a triangle times its unit normal, m^2.
Eigen::Vector3d triangle_normal(const std::array<Eigen::Vector3d, 3>& corners);
double smallest_angle(const std::array<Eigen::Vector3d, 3>& corners);  ///< smallest angle of a triangle, rad

double mean_edge_at(const Mesh& mesh, Vertex vertex);  ///< mean length of the vertex's edges, m

/// Sizes of a mesh with at least one face: its area in m^2, and the lengths of its smallest and largest edge
/// and their mean in m.
struct MeshMeasures {
    double area = 0;
    double smallest_edge = 0, mean_edge = 0, largest_edge = 0;
    double smallest_angle = 0;     ///< smallest of the angles of all faces, rad
    Eigen::Vector3d lower, upper;  ///< corners of the bounding box, m
    int boundary_loops = 0;
};

MeshMeasures measure(const Mesh& mesh);

}  // namespace sherd
