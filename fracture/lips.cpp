// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/lips.h"

#include <algorithm>

#include "core/contact/detection/contact_surface.h"
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

/// Whether two elements are nearer than half the sum of their thicknesses, or as near.
bool elements_overlap(PairKind kind, const Shell& shell, const Positions& x,
                      const std::array<Vertex, 4>& of) {
    std::array<Index, 4> vertices;
    std::ranges::transform(of, vertices.begin(), [](Vertex v) { return number(v); });
    const PairPositions local = columns(x, vertices);
    return std::sqrt(squared_distance(closest_points(kind, local), local)) <=
           half_thicknesses(shell, kind, vertices);
}

/// Whether `vertex` overlaps one of the faces around `other`.
bool overlaps_faces(const Mesh& mesh, const Shell& shell, const Positions& x, Vertex vertex, Vertex other) {
    const auto around = mesh.halfedges_around_target(mesh.halfedge(other));
    return std::any_of(around.begin(), around.end(), [&](Halfedge h) {
        return !mesh.is_border(h) &&
               elements_overlap(PairKind::vertex_triangle, shell, x,
                                {vertex, mesh.source(h), other, mesh.target(mesh.next(h))});
    });
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
    if ((x.col(number(v)) - x.col(number(w))).norm() <= shell.thickness[number(v)]) return false;
    if (overlaps_faces(mesh, shell, x, v, w) || overlaps_faces(mesh, shell, x, w, v)) return false;
    for (const Halfedge a : mesh.halfedges_around_target(mesh.halfedge(v)))
        for (const Halfedge b : mesh.halfedges_around_target(mesh.halfedge(w))) {
            const Vertex p = mesh.source(a), q = mesh.source(b);
            if (p == q || twins.has(p, q)) continue;  // they share a vertex, or are other twins
            if (elements_overlap(PairKind::edge_edge, shell, x, {p, v, q, w})) return false;
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
