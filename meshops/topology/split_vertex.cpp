// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/split_vertex.h"

#include <algorithm>

#include "meshops/topology/inherit_attributes.h"

namespace sherd {
namespace {

/// The faces around a vertex between two successive cut or boundary edges.
struct Sector {
    Face first;   ///< the face after the edge where the sector begins
    Face lowest;  ///< face of the lowest number, which does not depend on where the traversal begins
};

/// Returns the halfedge of the face that points to the vertex.
Halfedge corner(const Mesh& mesh, Face face, Vertex vertex) {
    Halfedge h = mesh.halfedge(face);
    while (mesh.target(h) != vertex) h = mesh.next(h);
    return h;
}

/// Returns the halfedge that points to the target of h in the next face around this vertex.
Halfedge turn(const Mesh& mesh, Halfedge h) {
    return mesh.opposite(mesh.next(h));
}

std::vector<Sector> sectors(const Mesh& mesh, Vertex vertex, const std::function<bool(Edge)>& is_cut) {
    const auto separates = [&](Halfedge h) {
        return mesh.is_border(h) || mesh.is_border(mesh.opposite(h)) || is_cut(mesh.edge(h));
    };
    std::vector<Sector> found;
    for (const Halfedge begin : mesh.halfedges_around_target(mesh.halfedge(vertex))) {
        if (mesh.is_border(begin) || !separates(begin)) continue;
        Face lowest = mesh.face(begin);
        for (Halfedge h = begin; !separates(mesh.next(h));) {
            h = turn(mesh, h);
            lowest = std::min(lowest, mesh.face(h));
        }
        found.push_back({mesh.face(begin), lowest});
    }
    std::sort(found.begin(), found.end(),
              [](const Sector& a, const Sector& b) { return a.lowest < b.lowest; });
    return found;
}

/// Separates the two faces of an edge: gives the second face a new edge, and makes the halfedges of both
/// edges that are without a face now borders. join_borders() links these with their neighbours. Returns the
/// new edge.
Edge detach(Mesh& mesh, Edge edge) {
    const Halfedge kept = mesh.halfedge(edge, 0), left = mesh.halfedge(edge, 1);
    const Halfedge created = mesh.add_edge();
    const Face face = mesh.face(left);
    mesh.set_target(created, mesh.target(left));
    mesh.set_target(mesh.opposite(created), mesh.target(kept));
    mesh.set_next(mesh.prev(left), created);
    mesh.set_next(created, mesh.next(left));
    mesh.set_face(created, face);
    if (mesh.halfedge(face) == left) mesh.set_halfedge(face, created);
    mesh.set_face(left, Mesh::null_face());
    mesh.set_face(mesh.opposite(created), Mesh::null_face());
    return mesh.edge(created);
}

/// Assigns `vertex` to the corners at the vertex `old` of all faces of a sector, whose two outer edges have
/// borders, and links these borders. Adds the faces to `faces`.
void join_borders(Mesh& mesh, const Sector& sector, Vertex old, Vertex vertex, std::vector<Face>& faces) {
    Halfedge h = corner(mesh, sector.first, old);
    const Halfedge out = mesh.opposite(h);
    for (;;) {
        mesh.set_target(h, vertex);
        faces.push_back(mesh.face(h));
        if (mesh.is_border(turn(mesh, h))) break;
        h = turn(mesh, h);
    }
    const Halfedge in = turn(mesh, h);
    mesh.set_target(in, vertex);
    mesh.set_next(in, out);
    mesh.set_halfedge(vertex, in);
}

Vertex copy_vertex(Mesh& mesh, Vertex vertex) {
    const Point point = mesh.point(vertex);  // a copy, since adding a vertex may move all points
    const Vertex copy = mesh.add_vertex(point);
    copy_attributes(mesh, vertex, copy);
    return copy;
}

/// Adds to `edges` the cut edges around a vertex that is split.
void add_opened_edges(const Mesh& mesh, Vertex vertex, const std::function<bool(Edge)>& is_cut,
                      std::vector<Edge>& edges) {
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex)))
        if (!mesh.is_border(mesh.edge(h)) && is_cut(mesh.edge(h))) edges.push_back(mesh.edge(h));
}

template <class Element>
void sort_unique(std::vector<Element>& elements) {
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
}

}  // namespace

TopologyChange split_vertices(Mesh& mesh, std::span<const Vertex> vertices,
                              const std::function<bool(Edge)>& is_cut) {
    std::vector<Edge> edges;
    for (const Vertex vertex : vertices)
        if (sectors(mesh, vertex, is_cut).size() > 1) add_opened_edges(mesh, vertex, is_cut, edges);
    sort_unique(edges);

    std::vector<Vertex> ends;
    for (const Edge edge : edges)
        for (const int side : {0, 1}) ends.push_back(mesh.vertex(edge, side));
    sort_unique(ends);
    std::vector<std::vector<Sector>> parts;
    for (const Vertex end : ends) parts.push_back(sectors(mesh, end, is_cut));

    TopologyChange change;
    for (const Edge edge : edges) {
        const Edge created = detach(mesh, edge);
        change.edges.push_back(copy_of(edge, created));
        change.opened.push_back({edge, created});
        change.changed.push_back(mesh.face(mesh.halfedge(created, 0)));
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
        std::vector<Face> keeping;
        join_borders(mesh, parts[i].front(), ends[i], ends[i], keeping);
        for (std::size_t s = 1; s < parts[i].size(); ++s) {
            const Vertex created = copy_vertex(mesh, ends[i]);
            change.vertices.push_back(copy_of(ends[i], created));
            join_borders(mesh, parts[i][s], ends[i], created, change.changed);
        }
    }
    sort_unique(change.changed);
    return change;
}

}  // namespace sherd
