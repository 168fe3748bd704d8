// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/crack_faces.h"

#include <algorithm>

#include "core/contact/crack_faces/crack_face.h"
#include "core/contact/detection/contact_surface.h"

namespace sherd {
namespace {

constexpr double rounding = 1e-9;  // largest distance, in thicknesses, of coincident ends of opposite edges

Index number(Vertex vertex) {
    return static_cast<Index>(vertex);
}

/// The halfedge of a boundary edge that belongs to a face.
Halfedge inner(const Mesh& mesh, Edge edge) {
    const Halfedge h = mesh.halfedge(edge);
    return mesh.is_border(h) ? mesh.opposite(h) : h;
}

/// Whether the distance of two elements is at most half the sum of their thicknesses. of: their vertices, in
/// the order of PairPositions.
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

/// An edge of a crack face, with the triangle to which it belongs.
struct CrackFaceSide {
    CrackFaceSide(const Mesh& mesh, const Shell& shell, Halfedge h)
        : ends{mesh.source(h), mesh.target(h)},
          apex(mesh.target(mesh.next(h))),
          rest(shell.rest),
          length((rest.col(number(ends[0])) - rest.col(number(ends[1]))).norm()),
          reach(rounding * shell.thickness[number(ends[0])]) {}

    /// Position of a vertex of the opposite crack face along this edge at rest: 0 at the first end, 1 at the
    /// second. It is exactly 0 or 1 if the vertex is a copy of that end, or if both crack faces were split at
    /// the same place, each by a crack of its own.
    double place(Vertex vertex) const {
        const Vector3d at = rest.col(number(vertex)), start = rest.col(number(ends[0])),
                       end = rest.col(number(ends[1]));
        if ((at - start).norm() <= reach) return 0;
        if ((at - end).norm() <= reach) return 1;
        return (at - start).dot(end - start) / (length * length);
    }
    std::array<Index, 4> stencil(Vertex vertex) const {
        return {number(vertex), number(ends[0]), number(ends[1]), number(apex)};
    }

    std::array<Vertex, 2> ends;
    Vertex apex;
    const Positions& rest;
    double length, reach;  ///< m, length at rest; largest distance from an end at which a vertex coincides
                           ///< with it
};

}  // namespace

void CrackFaces::open(const TopologyChange& change) {
    for (const WithParents<Vertex>& created : change.vertices) {
        if (!created.is_copy()) continue;
        for (const auto& [other, reach] : coincident.of(created.parent()))
            mark_coincident(other, created.element);
        mark_coincident(created.parent(), created.element);
    }
    for (const auto& [edge, created] : change.opened) edges.push_back({edge, created});
}

void CrackFaces::cut(const Mesh& mesh, const TopologyChange& change) {
    for (const WithParents<Edge>& half : change.edges) {
        if (!half.is_copy()) continue;
        for (std::size_t i = 0, count = edges.size(); i < count; ++i)
            for (const int side : {0, 1}) {
                if (edges[i][side] != half.parent()) continue;
                const Edge other = edges[i][1 - side];
                edges.push_back({half.element, other});
                for (const WithParents<Vertex>& inserted : change.vertices)
                    if (mesh.vertex(half.element, 0) == inserted.element ||
                        mesh.vertex(half.element, 1) == inserted.element)
                        for (const int end : {0, 1})
                            mark_coincident(inserted.element, mesh.vertex(other, end));
            }
    }
}

bool CrackFaces::apart(const Mesh& mesh, const Shell& shell, const Positions& x,
                       const CoincidentPair& pair) const {
    const auto [v, w] = pair;
    if ((x.col(number(v)) - x.col(number(w))).norm() <= shell.thickness[number(v)]) return false;
    if (overlaps_faces(mesh, shell, x, v, w) || overlaps_faces(mesh, shell, x, w, v)) return false;
    for (const Halfedge a : mesh.halfedges_around_target(mesh.halfedge(v)))
        for (const Halfedge b : mesh.halfedges_around_target(mesh.halfedge(w))) {
            const Vertex p = mesh.source(a), q = mesh.source(b);
            // Edges that share a vertex, or contain another pair, are not compared.
            if (p == q || coincident.has(p, q)) continue;
            if (elements_overlap(PairKind::edge_edge, shell, x, {p, v, q, w})) return false;
        }
    return true;
}

bool CrackFaces::release(const Mesh& mesh, const Shell& shell, const Positions& x) {
    bool any = false;
    for (const auto& [pair, reach] : coincident.all()) {
        if (!apart(mesh, shell, x, pair)) continue;
        // The pair is erased at once: elements that contain this and a later pair are then tested with the
        // later pair.
        coincident.erase(pair[0], pair[1]);
        any = true;
    }
    if (!any) return false;
    std::erase_if(edges, [&](const std::array<Edge, 2>& crack_faces) {
        return !has_coincident(mesh.vertex(crack_faces[0], 0)) &&
               !has_coincident(mesh.vertex(crack_faces[0], 1));
    });
    return true;
}

void CrackFaces::write(const Mesh& mesh, Shell& shell) const {
    for (const auto& [pair, reach] : coincident.all())
        shell.exempt_pairs.push_back({number(pair[0]), number(pair[1])});
    shell.crack_faces.clear();
    for (const std::array<Edge, 2>& crack_faces : edges)
        for (const int side : {0, 1}) {
            const CrackFaceSide crack_face(mesh, shell, inner(mesh, crack_faces[side]));
            const Halfedge facing = inner(mesh, crack_faces[1 - side]);
            const double from = crack_face.place(mesh.target(facing)),
                         to = crack_face.place(mesh.source(facing));
            const double common = std::min(to, 1.0) - std::max(from, 0.0);
            if (common <= 0) continue;
            const double stiffness = common * crack_face.length * shell.young[number(crack_face.ends[0])] / 8;
            for (const auto& [end, place] :
                 {std::pair{mesh.target(facing), from}, {mesh.source(facing), to}}) {
                const bool ahead = place >= 0 && place <= 1;
                if (!ahead ||
                    !(coincident.has(crack_face.ends[0], end) || coincident.has(crack_face.ends[1], end)))
                    continue;
                // Where ends of two opposite edges meet, each end is kept in front of the other edge, so that
                // each of the two contacts has half the stiffness.
                const bool meets_end = place == 0 || place == 1;
                shell.crack_faces.push_back({crack_face.stencil(end), meets_end ? stiffness : 2 * stiffness});
            }
        }
}

}  // namespace sherd
