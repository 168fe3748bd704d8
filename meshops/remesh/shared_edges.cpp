// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/shared_edges.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

namespace sherd {
namespace {

/// Returns, for each vertex, [V], the first of the vertices that coincide with it.
std::vector<Vertex> first_at_place(const Mesh& mesh) {
    std::vector<Vertex> sorted(mesh.vertices().begin(), mesh.vertices().end());
    std::ranges::stable_sort(sorted, {}, [&](Vertex v) { return mesh.point(v); });
    std::vector<Vertex> first(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const bool is_same = i > 0 && mesh.point(sorted[i]) == mesh.point(sorted[i - 1]);
        first[sorted[i]] = is_same ? first[sorted[i - 1]] : sorted[i];
    }
    return first;
}

struct PlacedEdge {
    std::array<Vertex, 2> ends;  ///< the first vertices at their places, ascending
    Edge edge;
};

std::vector<PlacedEdge> by_ends(const Mesh& mesh, const std::vector<Vertex>& place) {
    std::vector<PlacedEdge> edges;
    for (const Edge edge : mesh.edges()) {
        const auto [a, b] = std::minmax(place[mesh.vertex(edge, 0)], place[mesh.vertex(edge, 1)]);
        edges.push_back({{a, b}, edge});
    }
    std::ranges::stable_sort(edges, {}, &PlacedEdge::ends);
    return edges;
}

/// Whether two of the faces at `edges`, which have the same ends, have the same third corner, too.
bool have_doubled_faces(const Mesh& mesh, const std::vector<Vertex>& place,
                        std::span<const PlacedEdge> edges) {
    std::vector<Vertex> apexes;
    for (const PlacedEdge& one : edges)
        for (const int side : {0, 1})
            if (const Halfedge h = mesh.halfedge(one.edge, side); !mesh.is_border(h))
                apexes.push_back(place[mesh.target(mesh.next(h))]);
    std::ranges::sort(apexes);
    return std::ranges::adjacent_find(apexes) != apexes.end();
}

}  // namespace

SharedEdges shared_edges(const Mesh& mesh) {
    const std::vector<Vertex> place = first_at_place(mesh);
    const std::vector<PlacedEdge> edges = by_ends(mesh, place);
    SharedEdges found;
    found.is_shared.resize(mesh.number_of_edges(), 0);
    std::vector<char> is_end(mesh.number_of_vertices(), 0);
    for (auto begin = edges.begin(); begin != edges.end();) {
        const auto end = std::ranges::upper_bound(begin, edges.end(), begin->ends, {}, &PlacedEdge::ends);
        const std::span<const PlacedEdge> alike(begin, end);
        begin = end;
        if (alike.size() < 2 || have_doubled_faces(mesh, place, alike)) continue;
        for (const PlacedEdge& one : alike) {
            found.is_shared[one.edge] = 1;
            for (const int i : {0, 1}) is_end[mesh.vertex(one.edge, i)] = 1;
        }
    }
    std::vector<std::vector<Vertex>> at(mesh.number_of_vertices());
    for (const Vertex v : mesh.vertices())
        if (is_end[v]) at[place[v]].push_back(v);
    std::ranges::copy_if(at, std::back_inserter(found.coincident),
                         [](const auto& some) { return some.size() > 1; });
    return found;
}

}  // namespace sherd
