// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/start_exemptions.h"

#include <algorithm>

#include "core/contact/detection/contact_surface.h"
#include "fracture/shell/mesh_inheritance.h"
#include "meshops/intersect/triangles_meet.h"

namespace sherd {
namespace {

using Corners = std::array<Index, 3>;

std::vector<Corners> corners_around(const Mesh& mesh, Vertex vertex) {
    std::vector<Corners> around;
    for (const Face face : mesh.faces_around_target(mesh.halfedge(vertex)))
        if (face != Mesh::null_face()) around.push_back(face_vertices(mesh, face));
    return around;
}

/// The other ends of the edges at a vertex.
std::vector<Index> neighbours(const Mesh& mesh, Vertex vertex) {
    std::vector<Index> ends;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex)))
        ends.push_back(static_cast<Index>(mesh.source(h)));
    return ends;
}

/// Returns the pair of two faces, with their shared corners first.
TrianglePair triangle_pair(const Positions& x, Corners a, Corners b) {
    TrianglePair pair;
    const auto is_in = [](const Corners& other) {
        return [&](Index v) { return std::ranges::count(other, v) > 0; };
    };
    const Corners given = a;
    // std::ranges::stable_partition does not compile with clang++ 14.
    pair.shared = static_cast<int>(std::stable_partition(a.begin(), a.end(), is_in(b)) - a.begin());
    std::stable_partition(b.begin(), b.end(), is_in(given));
    for (int i = 0; i < 3; ++i) {
        pair.a[i] = x.col(a[i]);
        pair.b[i] = x.col(b[i]);
    }
    return pair;
}

bool faces_meet(const Positions& x, const std::vector<Corners>& some, const std::vector<Corners>& others) {
    return std::ranges::any_of(some, [&](const Corners& a) {
        return std::ranges::any_of(others,
                                   [&](const Corners& b) { return triangles_meet(triangle_pair(x, a, b)); });
    });
}

/// Distance, m, at which two elements count as separated: their activation distance, or half the sum of their
/// thicknesses if they touch at rest, where the activation distance is nearly zero.
double needed(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices) {
    const double usual = activation_distance_of_sheets(shell, kind, vertices);
    const double together = half_thicknesses(shell, kind, vertices);
    return usual < touching * together ? together : usual;
}

}  // namespace

void StartExemptions::add(const Mesh& mesh, std::span<const StartOverlap> overlaps) {
    for (const StartOverlap& overlap : overlaps) {
        const bool is_near = !overlap.crossing && overlap.distance > touching * overlap.needed;
        for (const Index a : face_vertices(mesh, Face(overlap.faces[0])))
            for (const Index b : face_vertices(mesh, Face(overlap.faces[1])))
                if (a != b) pairs.add(Vertex(a), Vertex(b), is_near ? overlap.distance : 0);
    }
}

void StartExemptions::follow(const TopologyChange& change) {
    if (pairs.empty()) return;
    for (const WithParents<Vertex>& inserted : change.vertices)
        for (const auto& [parent, weight] : inserted.parents)
            for (const auto& [other, reach] : pairs.of(parent)) pairs.add(inserted.element, other, reach);
}

bool StartExemptions::apart(const Mesh& mesh, const Shell& shell, const VertexPairs::Pair& pair) const {
    const Vertex v = pair.vertices[0], w = pair.vertices[1];
    const Positions& x = shell.position;
    const std::vector<Corners> of_v = corners_around(mesh, v), of_w = corners_around(mesh, w);
    if (pair.reach == 0 && faces_meet(x, of_v, of_w)) return false;
    // Elements that share a vertex do not collide, and elements that contain another exempt pair are tested
    // with that pair.
    const auto free = [&](PairKind kind, const std::array<Index, 4>& vertices) {
        const int first = vertices_of_first(kind);
        for (int i = 0; i < first; ++i)
            for (int j = first; j < 4; ++j) {
                const Vertex a(vertices[i]), b(vertices[j]);
                if (a == b || (pairs.has(a, b) && !(a == v && b == w) && !(a == w && b == v))) return true;
            }
        const PairPositions at = columns(x, vertices);
        return std::sqrt(squared_distance(closest_points(kind, at), at)) >= needed(shell, kind, vertices);
    };
    const Index a = static_cast<Index>(v), b = static_cast<Index>(w);
    const auto free_of = [&](Index vertex, const std::vector<Corners>& faces) {
        return std::ranges::all_of(faces, [&](const Corners& face) {
            return free(PairKind::vertex_triangle, {vertex, face[0], face[1], face[2]});
        });
    };
    if (!free_of(a, of_w) || !free_of(b, of_v)) return false;
    const std::vector<Index> ends = neighbours(mesh, w);
    return std::ranges::all_of(neighbours(mesh, v), [&](Index p) {
        return std::ranges::all_of(ends, [&](Index q) { return free(PairKind::edge_edge, {p, a, q, b}); });
    });
}

bool StartExemptions::release(const Mesh& mesh, const Shell& shell) {
    bool any = false;
    for (const VertexPairs::Pair& pair : pairs.all()) {
        if (!apart(mesh, shell, pair)) continue;
        // The pair is erased at once: elements that contain this and a later pair are then tested with the
        // later pair.
        pairs.erase(pair.vertices[0], pair.vertices[1]);
        any = true;
    }
    return any;
}

void StartExemptions::write(Shell& shell) const {
    shell.near.clear();
    for (const auto& [vertices, reach] : pairs.all()) {
        const std::array both{static_cast<Index>(vertices[0]), static_cast<Index>(vertices[1])};
        if (reach > 0)
            shell.near.push_back({both, reach});
        else
            shell.exempt_pairs.push_back(both);
    }
}

}  // namespace sherd
