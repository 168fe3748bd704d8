// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/lips.h"

#include <algorithm>

#include "core/contact/lips/lip.h"

namespace sherd {
namespace {

Index number(Vertex vertex) {
    return static_cast<Index>(vertex);
}

/// The halfedge of a boundary edge that belongs to its face.
Halfedge inner(const Mesh& mesh, Edge edge) {
    const Halfedge h = mesh.halfedge(edge);
    return mesh.is_border(h) ? mesh.opposite(h) : h;
}

double distance(PairKind kind, const Positions& x, const std::array<Vertex, 4>& vertices) {
    PairPositions local;
    for (int i = 0; i < 4; ++i) local.col(i) = x.col(number(vertices[i]));
    return std::sqrt(squared_distance(closest_points(kind, local), local));
}

/// Distance, m, of `vertex` to the nearest of the faces around `other`.
double distance_to_faces(const Mesh& mesh, const Positions& x, Vertex vertex, Vertex other) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(other)))
        if (!mesh.is_border(h))
            nearest = std::min(nearest, distance(PairKind::vertex_triangle, x,
                                                 {vertex, mesh.source(h), other, mesh.target(mesh.next(h))}));
    return nearest;
}

}  // namespace

void Lips::open(const TopologyChange& change) {
    for (const Born<Vertex>& created : change.vertices) {
        if (!created.is_copy()) continue;
        for (const auto& [other, reach] : twins.of(created.parent())) lie_together(other, created.element);
        lie_together(created.parent(), created.element);
    }
    for (const auto& [edge, created] : change.opened) edges.push_back({edge, created});
}

void Lips::cut(const Mesh& mesh, const TopologyChange& change) {
    for (const Born<Edge>& half : change.edges) {
        if (!half.is_copy()) continue;
        for (std::size_t i = 0, count = edges.size(); i < count; ++i)
            for (const int side : {0, 1}) {
                if (edges[i][side] != half.parent()) continue;
                const Edge other = edges[i][1 - side];
                edges.push_back({half.element, other});
                for (const Born<Vertex>& born : change.vertices)
                    if (mesh.vertex(half.element, 0) == born.element ||
                        mesh.vertex(half.element, 1) == born.element)
                        for (const int end : {0, 1}) lie_together(born.element, mesh.vertex(other, end));
            }
    }
}

bool Lips::apart(const Mesh& mesh, const Shell& shell, const Positions& x, const Twins& pair) const {
    const auto [v, w] = pair;
    const double thickness = shell.thickness[number(v)];
    if ((x.col(number(v)) - x.col(number(w))).norm() <= thickness) return false;
    if (distance_to_faces(mesh, x, v, w) <= thickness) return false;
    if (distance_to_faces(mesh, x, w, v) <= thickness) return false;
    for (const Halfedge a : mesh.halfedges_around_target(mesh.halfedge(v)))
        for (const Halfedge b : mesh.halfedges_around_target(mesh.halfedge(w))) {
            const Vertex p = mesh.source(a), q = mesh.source(b);
            if (p == q || twins.has(p, q)) continue;  // they share a vertex, or are other twins
            if (distance(PairKind::edge_edge, x, {p, v, q, w}) <= thickness) return false;
        }
    return true;
}

bool Lips::release(const Mesh& mesh, const Shell& shell, const Positions& x) {
    bool any = false;
    for (const auto& [pair, reach] : twins.all()) {
        if (!apart(mesh, shell, x, pair)) continue;
        // The pair is erased at once, so that the next pair takes the elements that they share into account.
        twins.erase(pair[0], pair[1]);
        any = true;
    }
    if (!any) return false;
    std::erase_if(edges, [&](const std::array<Edge, 2>& lips) {
        return !has_twin(mesh.vertex(lips[0], 0)) && !has_twin(mesh.vertex(lips[0], 1));
    });
    return true;
}

void Lips::write(const Mesh& mesh, Shell& shell) const {
    for (const auto& [pair, reach] : twins.all()) shell.twins.push_back({number(pair[0]), number(pair[1])});
    shell.lips.clear();
    for (const std::array<Edge, 2>& lips : edges)
        for (const int side : {0, 1}) {
            const Halfedge h = inner(mesh, lips[side]), facing = inner(mesh, lips[1 - side]);
            const Vertex a = mesh.source(h), b = mesh.target(h), apex = mesh.target(mesh.next(h));
            const double length = (shell.rest.col(number(a)) - shell.rest.col(number(b))).norm();
            for (const auto& [own, other] : {Twins{a, mesh.target(facing)}, Twins{b, mesh.source(facing)}})
                if (twins.has(own, other) && shell.rest.col(number(own)) == shell.rest.col(number(other)))
                    shell.lips.push_back({{number(other), number(a), number(b), number(apex)},
                                          length * shell.young[number(a)] / 8});
        }
}

}  // namespace sherd
