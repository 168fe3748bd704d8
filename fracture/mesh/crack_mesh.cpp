// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/mesh/crack_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "fracture/mesh/mesh_state.h"
#include "meshops/error.h"
#include "meshops/topology/split_vertex.h"

namespace sherd {

CrackMesh::CrackMesh(Mesh mesh) : halfedges(std::move(mesh)) {
    states.reserve(halfedges.number_of_edges());
    for (const Edge edge : halfedges.edges()) {
        states.push_back(halfedges.is_border(edge) ? EdgeState::boundary : EdgeState::interior);
        edge_origin.push_back(edge);
        outline.push_back(halfedges.is_border(edge));
    }
    for (const Vertex vertex : halfedges.vertices()) vertex_origin.push_back(vertex);
}

bool CrackMesh::is_tip(Vertex vertex) const {
    Edge crack;  // none so far
    for (const Halfedge h : halfedges.halfedges_around_target(halfedges.halfedge(vertex))) {
        const Edge edge = halfedges.edge(h);
        if (states[edge] == EdgeState::interior) continue;
        if (crack.is_valid() && original(edge) != crack) return false;
        crack = original(edge);
    }
    return crack.is_valid();
}

int CrackMesh::boundary_vertices(Edge edge) const {
    int count = 0;
    for (const int side : {0, 1}) {
        const Halfedge to_end = halfedges.halfedge(edge, side);
        const auto around = halfedges.halfedges_around_target(to_end);
        count += std::any_of(around.begin(), around.end(), [&](Halfedge h) {
            return halfedges.edge(h) != edge && states[halfedges.edge(h)] != EdgeState::interior;
        });
    }
    return count;
}

void CrackMesh::visit_state(StateVisitor& visit) {
    auto& [halfedges, states, vertex_origin, edge_origin, outline, to_open] = *this;
    visit_mesh(visit, halfedges);
    visit(states, vertex_origin, edge_origin, outline, to_open);
}

bool CrackMesh::is_cracked(Vertex vertex) const {
    const auto around = halfedges.halfedges_around_target(halfedges.halfedge(vertex));
    return std::any_of(around.begin(), around.end(), [this](Halfedge h) {
        const Edge edge = halfedges.edge(h);
        return states[edge] != EdgeState::interior && !is_outline(edge);
    });
}

std::optional<AdvancedEdge> CrackMesh::advance(Vertex tip, const Eigen::Vector3d& direction,
                                               const AdvanceOptions& options) {
    AdvanceOptions all = options;
    all.kept.is_fixed_vertex = [&](Vertex vertex) {
        return is_cracked(vertex) || options.kept.is_fixed_vertex(vertex);
    };
    all.kept.is_line = [&](Edge edge) {
        return states[edge] != EdgeState::interior || options.kept.is_line(edge);
    };
    auto advanced = advance_edge(halfedges, tip, direction, all);
    if (advanced) follow(advanced->change);
    return advanced;
}

void CrackMesh::follow(const TopologyChange& change) {
    for (const WithParents<Vertex>& vertex : change.vertices) vertex_origin.push_back(vertex.element);
    for (const WithParents<Edge>& edge : change.edges) {
        states.push_back(edge.is_copy() ? states[edge.parent()] : EdgeState::interior);
        outline.push_back(edge.is_copy() ? outline[edge.parent()] : 0);
        edge_origin.push_back(edge.element);
    }
    for (const WithParents<Edge>& edge : change.edges)
        if (edge.is_copy() && states[edge.element] != EdgeState::interior && !is_outline(edge.element))
            share_origin(edge);
    for (const WithParents<Vertex>& vertex : change.vertices)
        if (is_cracked(vertex.element)) to_open.push_back(vertex.element);
}

// Must be called when an edge of a crack face has been split into two halves, of which `inserted` is the new
// one. The half that still shares an end with the opposite crack face gets the original that the edges of
// both crack faces have.
void CrackMesh::share_origin(const WithParents<Edge>& inserted) {
    const Edge half = inserted.parent();
    const auto meets_other_crack_face = [&](Vertex end) {
        const auto around = halfedges.halfedges_around_target(halfedges.halfedge(end));
        return std::any_of(around.begin(), around.end(), [&](Halfedge h) {
            const Edge edge = halfedges.edge(h);
            return edge != half && edge != inserted.element && original(edge) == original(half);
        });
    };
    if (meets_other_crack_face(halfedges.vertex(inserted.element, 0)) ||
        meets_other_crack_face(halfedges.vertex(inserted.element, 1)))
        std::swap(edge_origin[half], edge_origin[inserted.element]);
}

CrackMesh::Change CrackMesh::fail(std::span<const Edge> edges) {
    for (const Edge edge : edges) {
        if (states[edge] != EdgeState::interior)
            throw Error("edge " + std::to_string(edge.idx()) +
                        " cannot fail: it is not interior, or given twice");
        states[edge] = EdgeState::fractured_interior;
    }
    Change change;
    std::vector<Vertex> ends = std::exchange(to_open, {});
    for (const Edge edge : edges) {
        change.boundary_vertices.push_back(boundary_vertices(edge));
        for (const int side : {0, 1}) ends.push_back(halfedges.vertex(edge, side));
    }
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());

    change.topology =
        split_vertices(halfedges, ends, [this](Edge edge) { return states[edge] != EdgeState::interior; });
    states.resize(halfedges.number_of_edges(), EdgeState::boundary);
    for (const auto& [edge, created] : change.topology.opened) states[edge] = EdgeState::boundary;
    outline.resize(halfedges.number_of_edges(), 0);
    for (const WithParents<Edge>& edge : change.topology.edges)
        edge_origin.push_back(original(edge.parent()));
    for (const WithParents<Vertex>& vertex : change.topology.vertices)
        vertex_origin.push_back(original(vertex.parent()));
    return change;
}

}  // namespace sherd
