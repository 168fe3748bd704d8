// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <span>
#include <string>

#include "fracture/mesh/crack_mesh.h"
#include "tests/support/mesh/corner_rule.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd::test {

inline CornerRule::VertexPair vertex_pair(const Mesh& mesh, Edge edge) {
    return CornerRule::ordered(static_cast<int>(mesh.vertex(edge, 0).idx()),
                               static_cast<int>(mesh.vertex(edge, 1).idx()));
}

/// Returns what makes a mesh not a 2-manifold; empty: nothing.
inline std::string manifold_fault(const Mesh& mesh) {
    if (!mesh.is_valid(false)) return "Surface_mesh::is_valid";
    if (!CGAL::is_valid_polygon_mesh(mesh)) return "CGAL::is_valid_polygon_mesh";
    std::size_t reached = 0;
    for (const Vertex vertex : mesh.vertices()) {
        int gaps = 0;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex))) {
            if (mesh.target(h) != vertex) return "a halfedge around a vertex that points elsewhere";
            gaps += mesh.is_border(h);
            ++reached;
        }
        if (gaps > 1) return "a vertex of more than one fan";
    }
    return reached == mesh.number_of_halfedges() ? "" : "a halfedge that is around no vertex";
}

/// Returns the first difference between the faces' corners after failures and the rule; empty: none. `after`
/// must have the faces of `before` in their order; their corners must be at one vertex exactly where the rule
/// says so, and each vertex must be a copy of the vertex that its corners had before. old_faces:
/// triangles_of(before).
inline std::string corner_fault(const Mesh& before, const std::vector<std::array<int, 3>>& old_faces,
                                CornerRule& rule, const CrackMesh& after) {
    const auto faces = triangles_of(after.mesh());
    if (faces.size() != old_faces.size()) return "number of faces";
    std::vector<int> vertex_of_root(3 * faces.size(), -1);
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
        for (int i = 0; i < 3; ++i) {
            int& vertex = vertex_of_root[rule.vertex(f, i)];
            if (vertex < 0) vertex = faces[f][i];
            if (vertex != faces[f][i]) return "corner " + std::to_string(i) + " of face " + std::to_string(f);
            const Vertex ancestor = after.original(Vertex(static_cast<unsigned>(vertex)));
            if (static_cast<int>(ancestor.idx()) != old_faces[f][i]) return "ancestor of a vertex";
        }
    for (const Vertex vertex : after.mesh().vertices())
        if (after.mesh().point(vertex) != before.point(after.original(vertex))) return "place of a vertex";
    const std::size_t count = after.mesh().number_of_vertices();
    return rule.vertex_count() == static_cast<int>(count) ? "" : "number of vertices";
}

/// Returns the first difference between the states of edges and the rule; empty: none.
inline std::string edge_fault(const Mesh& before, const CornerRule& rule, std::span<const Edge> failed,
                              const CrackMesh& after) {
    if (after.mesh().number_of_edges() != before.number_of_edges() + rule.open_count())
        return "number of edges";
    std::vector<EdgeState> expected;
    for (const Edge edge : before.edges())
        expected.push_back(before.is_border(edge) ? EdgeState::boundary : EdgeState::interior);
    for (const Edge edge : failed) {
        const auto [a, b] = vertex_pair(before, edge);
        expected[edge] = rule.is_open(a, b) ? EdgeState::boundary : EdgeState::fractured_interior;
    }
    for (const Edge edge : after.mesh().edges()) {
        if (after.state(edge) != expected[after.original(edge)])
            return "state of edge " + std::to_string(edge.idx());
        if (after.mesh().is_border(edge) != (after.state(edge) == EdgeState::boundary))
            return "border and state of edge " + std::to_string(edge.idx());
    }
    return "";
}

/// Returns the first difference between `after`, the mesh `before` in which the edges `failed` have failed,
/// and the corner rule; empty: none.
inline std::string disagreement(const Mesh& before, std::span<const Edge> failed, const CrackMesh& after) {
    std::vector<CornerRule::VertexPair> pairs;
    for (const Edge edge : failed) pairs.push_back(vertex_pair(before, edge));
    const auto faces = triangles_of(before);
    CornerRule rule(faces, std::move(pairs));
    std::string fault = corner_fault(before, faces, rule, after);
    if (fault.empty()) fault = edge_fault(before, rule, failed, after);
    return fault.empty() ? manifold_fault(after.mesh()) : fault;
}

}  // namespace sherd::test
