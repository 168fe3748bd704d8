// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/mesh_inheritance.h"

#include <algorithm>
#include <set>

namespace sherd {
namespace {

template <class Element>
std::vector<IndexWithParents> inserted(const std::vector<WithParents<Element>>& inserted) {
    std::vector<IndexWithParents> all;
    for (const auto& [element, parents] : inserted) {
        all.push_back({static_cast<Index>(element), {}});
        for (const auto& [parent, weight] : parents)
            all.back().parents.push_back({static_cast<Index>(parent), weight});
    }
    return all;
}

/// The old corners of changed faces with their masses, ascending.
std::vector<ShellChange::Weight> weights_of(const std::vector<ShellChange::ChangedFace>& changed,
                                            const Shell& before) {
    std::set<Index> corners;
    for (const auto& [face, vertices] : changed) corners.insert(vertices.begin(), vertices.end());
    std::vector<ShellChange::Weight> weights;
    for (const Index vertex : corners) weights.push_back({vertex, before.mass[vertex]});
    return weights;
}

std::vector<ShellChange::CrossingEdge> crossing_edges(const TopologyChange& topology, const OldSides& old) {
    std::vector<ShellChange::CrossingEdge> crossing;
    const auto add = [&](Edge edge) {
        crossing.push_back({static_cast<Index>(edge), {}});
        for (const Edge side : old.around(edge)) crossing.back().around.push_back(static_cast<Index>(side));
    };
    for (const Edge edge : topology.flipped) add(edge);
    for (const WithParents<Edge>& edge : topology.edges)
        if (!edge.is_copy()) add(edge.element);
    return crossing;
}

}  // namespace

std::array<Index, 3> face_vertices(const Mesh& mesh, Face face) {
    std::array<Index, 3> vertices;
    Halfedge h = mesh.halfedge(face);
    for (Index& vertex : vertices) {
        vertex = static_cast<Index>(mesh.target(h));
        h = mesh.next(h);
    }
    return vertices;
}

ShellChange shell_change(const Mesh& mesh, const TopologyChange& topology, const Shell& before) {
    ShellChange change{.vertices = inserted(topology.vertices),
                       .edges = inserted(topology.edges),
                       .faces = inserted(topology.faces),
                       .moved = inserted(topology.moved)};
    if (topology.reshaped.empty()) return change;
    for (const Face face : topology.changed)
        change.changed.push_back({static_cast<Index>(face), before.triangles[face].vertices});
    for (const auto& [face, shares] : topology.reshaped) {
        change.reshaped.push_back({static_cast<Index>(face), {}});
        for (const auto& [parent, share] : shares)
            change.reshaped.back().parents.push_back({static_cast<Index>(parent), share});
    }
    change.weights = weights_of(change.changed, before);
    change.crossing = crossing_edges(topology, OldSides(mesh, topology, before));
    return change;
}

OldSides::OldSides(const Mesh& mesh, const TopologyChange& topology, const Shell& before)
    : mesh(mesh), topology(topology), before(before) {
    for (const Edge edge : topology.flipped) {
        const auto [a, b, above, below] = before.hinges[before.edge_hinge[edge]].vertices;
        flipped.push_back({{a, b}, edge});
    }
}

Edge OldSides::between(Index from, Index to) const {
    for (const auto& [ends, edge] : flipped)
        if (std::ranges::is_permutation(ends, std::array{from, to})) return edge;
    const auto old_edge = [&](Vertex a, Vertex b) {
        const Halfedge h = mesh.halfedge(a, b);
        if (!h.is_valid()) return Edge();
        const Edge edge = mesh.edge(h);
        const bool is_old = edge.idx() < before.edge_hinge.size();
        return is_old && std::ranges::count(topology.flipped, edge) == 0 ? edge : Edge();
    };
    const Vertex a(static_cast<unsigned>(from)), b(static_cast<unsigned>(to));
    if (const Edge whole = old_edge(a, b); whole.is_valid()) return whole;
    for (const auto& [inserted, parents] : topology.vertices)
        for (const Vertex end : {a, b})
            if (const Edge half = old_edge(end, inserted); half.is_valid()) return half;
    return Edge();
}

std::vector<Edge> OldSides::around(Edge edge) const {
    std::set<Edge> sides;
    for (const int side : {0, 1}) {
        const Halfedge h = mesh.halfedge(edge, side);
        if (mesh.is_border(h)) continue;
        const auto reshaped =
            std::ranges::find(topology.reshaped, mesh.face(h), &TopologyChange::Reshaped::face);
        for (const auto& [parent, share] : reshaped->shares) {
            const std::array<Index, 3>& corners = before.triangles[parent].vertices;
            for (int i = 0; i < 3; ++i)
                if (const Edge old = between(corners[i], corners[(i + 1) % 3]); old.is_valid())
                    sides.insert(old);
        }
    }
    return {sides.begin(), sides.end()};
}

}  // namespace sherd
