// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/crack_mesh.h"

#include <algorithm>
#include <string>

#include "meshops/error.h"
#include "meshops/split_vertex.h"

namespace sherd {

CrackMesh::CrackMesh(Mesh mesh) : halfedges(std::move(mesh)) {
    states.reserve(halfedges.number_of_edges());
    for (const Edge edge : halfedges.edges()) {
        states.push_back(halfedges.is_border(edge) ? EdgeState::boundary : EdgeState::interior);
        edge_origin.push_back(edge);
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

CrackMesh::Change CrackMesh::fail(std::span<const Edge> edges) {
    for (const Edge edge : edges) {
        if (states[edge] != EdgeState::interior)
            throw Error("edge " + std::to_string(edge.idx()) +
                        " cannot fail: it is not interior, or given twice");
        states[edge] = EdgeState::fractured_interior;
    }
    Change change;
    std::vector<Vertex> ends;
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
    for (const Born<Edge>& edge : change.topology.edges) edge_origin.push_back(original(edge.parent()));
    for (const Born<Vertex>& vertex : change.topology.vertices)
        vertex_origin.push_back(original(vertex.parent()));
    return change;
}

}  // namespace sherd
