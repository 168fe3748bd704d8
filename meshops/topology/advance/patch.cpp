// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/advance/patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "meshops/mesh_measures.h"
#include "meshops/topology/property_border.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

std::set<Vertex> with_neighbours(const Mesh& mesh, const std::set<Vertex>& vertices) {
    std::set<Vertex> all = vertices;
    for (const Vertex vertex : vertices)
        for (const Vertex other : mesh.vertices_around_target(mesh.halfedge(vertex))) all.insert(other);
    return all;
}

std::set<Face> faces_at(const Mesh& mesh, const std::set<Vertex>& vertices) {
    std::set<Face> faces;
    for (const Vertex vertex : vertices)
        for (const Face face : mesh.faces_around_target(mesh.halfedge(vertex)))
            if (face != Mesh::null_face()) faces.insert(face);
    return faces;
}

/// Copies faces of the mesh into the patch. A face that CGAL cannot add, since it does not fit, stays
/// outside.
void copy_faces(const Mesh& mesh, const std::set<Face>& faces, Patch& patch) {
    std::map<Vertex, Vertex> local;
    for (const Face face : faces) {
        std::array<Vertex, 3> corners = face_corners(mesh, face);
        for (Vertex& corner : corners) {
            const auto [known, is_new] = local.try_emplace(corner);
            if (is_new) {
                known->second = patch.mesh.add_vertex(mesh.point(corner));
                patch.vertices.push_back(corner);
            }
            corner = known->second;
        }
        patch.mesh.add_face(corners);
    }
}

std::size_t face_count(const Mesh& mesh, Vertex vertex) {
    const auto around = mesh.faces_around_target(mesh.halfedge(vertex));
    return std::ranges::count_if(around, [](Face face) { return face != Mesh::null_face(); });
}

Mobility mobility_of(const Patch& patch, Vertex vertex) {
    constexpr double straight = 1e-9;
    std::vector<Vector3d> ways;
    for (const Halfedge in : patch.mesh.halfedges_around_target(patch.mesh.halfedge(vertex)))
        if (patch.line[patch.mesh.edge(in)])
            ways.push_back(
                (position(patch.mesh, patch.mesh.source(in)) - position(patch.mesh, vertex)).normalized());
    if (ways.empty()) return Mobility::free;
    return ways.size() == 2 && (ways[0] + ways[1]).norm() < straight ? Mobility::slides : Mobility::fixed;
}

}  // namespace

bool is_constrained_line(const Mesh& mesh, Edge edge, const LineConstraints& lines) {
    if (mesh.is_border(edge) || lines.is_line(edge)) return true;
    const Halfedge h = mesh.halfedge(edge), other = mesh.opposite(h);
    const Vector3d normal = triangle_normal(face_points(mesh, mesh.face(h))).normalized();
    const Vector3d next = triangle_normal(face_points(mesh, mesh.face(other))).normalized();
    return normal.dot(next) < std::cos(lines.crease * std::numbers::pi / 180) || is_property_border(mesh, h);
}

Vertex Patch::local(Vertex vertex) const {
    const auto at = std::ranges::find(vertices, vertex);
    return at == vertices.end() ? Mesh::null_vertex()
                                : Vertex(static_cast<Mesh::size_type>(at - vertices.begin()));
}

Patch patch_around(const Mesh& mesh, std::span<const Vertex> centres, const LineConstraints& lines) {
    Patch patch;
    const std::set<Vertex> core(centres.begin(), centres.end());
    copy_faces(mesh, faces_at(mesh, with_neighbours(mesh, core)), patch);
    for (const Edge edge : patch.mesh.edges()) {
        const Edge whole = mesh.edge(mesh.halfedge(patch.vertices[patch.mesh.vertex(edge, 0)],
                                                   patch.vertices[patch.mesh.vertex(edge, 1)]));
        patch.rim.push_back(patch.mesh.is_border(edge) && !mesh.is_border(whole));
        patch.line.push_back(patch.rim.back() || is_constrained_line(mesh, whole, lines));
    }
    for (const Vertex vertex : patch.mesh.vertices()) {
        const Vertex whole = patch.vertices[vertex];
        const bool is_cut_off = face_count(patch.mesh, vertex) != face_count(mesh, whole);
        patch.mobility.push_back(is_cut_off || lines.is_fixed_vertex(whole) ? Mobility::fixed
                                                                            : mobility_of(patch, vertex));
    }
    return patch;
}

}  // namespace sherd
