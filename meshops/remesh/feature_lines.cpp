// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/feature_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/disjoint_sets.h"
#include "meshops/mesh_measures.h"
#include "meshops/remesh/shared_edges.h"
#include "meshops/topology/property_border.h"

namespace sherd {
namespace {

using Eigen::Vector3d;
using EdgeMarks = std::vector<char>;

double length_of(const Mesh& mesh, Edge edge) {
    return (position(mesh, mesh.vertex(edge, 1)) - position(mesh, mesh.vertex(edge, 0))).norm();
}

double angle_between(const Vector3d& a, const Vector3d& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// Whether the dihedral angle of an interior edge exceeds `degrees`, and the angle between the mean normals
/// of the faces within `reach` (m) on its two sides exceeds half of `degrees`. The second condition is false
/// on a rough surface, which bends at its edges, but not as a whole.
bool is_sharp(const Mesh& mesh, Edge edge, double degrees, double reach) {
    const Halfedge h = mesh.halfedge(edge);
    const Vector3d left = triangle_normal(face_points(mesh, mesh.face(h)));
    const Vector3d right = triangle_normal(face_points(mesh, mesh.face(mesh.opposite(h))));
    if (angle_between(left, right) <= degrees) return false;
    const Vector3d begin = position(mesh, mesh.source(h)), end = position(mesh, mesh.target(h));
    const Vector3d middle = (begin + end) / 2;
    const Vector3d leftward = (left.normalized() + right.normalized()).cross(end - begin);
    std::array<Vector3d, 2> sides{left, right};
    for (const Face face : faces_near(mesh, {mesh.face(h), mesh.face(mesh.opposite(h))}, middle, reach)) {
        if (face == mesh.face(h) || face == mesh.face(mesh.opposite(h))) continue;
        const bool is_left = (centroid(mesh, face) - middle).dot(leftward) > 0;
        sides[is_left ? 0 : 1] += triangle_normal(face_points(mesh, face));
    }
    return angle_between(sides[0], sides[1]) > degrees / 2;
}

/// Removes the marks of sharp edges if the connected ones are shorter than `shortest` (m) together: these are
/// noise, or too short to be kept as an edge. Sharp edges that are connected to other marked edges stay.
void drop_short(const Mesh& mesh, const EdgeMarks& sharp, EdgeMarks& marks, double shortest) {
    DisjointSets joined(mesh.number_of_vertices());
    for (const Edge edge : mesh.edges())
        if (marks[edge]) joined.join(mesh.vertex(edge, 0), mesh.vertex(edge, 1));
    std::vector<double> length(mesh.number_of_vertices(), 0);
    for (const Edge edge : mesh.edges())
        if (marks[edge])
            length[joined.find(mesh.vertex(edge, 0))] += sharp[edge] ? length_of(mesh, edge) : shortest;
    for (const Edge edge : mesh.edges())
        if (marks[edge] && length[joined.find(mesh.vertex(edge, 0))] < shortest) marks[edge] = 0;
}

EdgeMarks marked_edges(const Mesh& mesh, double degrees, double shortest, const std::vector<char>& kept,
                       const EdgeMarks& shared) {
    EdgeMarks marks = shared, sharp(mesh.number_of_edges(), 0);
    for (const Face face : mesh.faces())
        if (kept[face])
            for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) marks[mesh.edge(h)] = 1;
    for (const Edge edge : mesh.edges()) {
        if (mesh.is_border(edge) || is_property_border(mesh, mesh.halfedge(edge))) marks[edge] = 1;
        if (marks[edge]) continue;
        marks[edge] = sharp[edge] = is_sharp(mesh, edge, degrees, shortest / 3);
    }
    drop_short(mesh, sharp, marks, shortest);
    return marks;
}

/// Traces the lines of marked edges.
class LineTracing {
  public:
    LineTracing(const Mesh& mesh, const EdgeMarks& marks, double degrees, double reach,
                const std::vector<char>& kept, const SharedEdges& shared)
        : mesh(mesh), marks(marks), shared(shared.is_shared) {
        found.of_edge.resize(mesh.number_of_edges());
        found.coincident = shared.coincident;
        for (const Vertex v : mesh.vertices()) found.is_corner.push_back(is_corner(v, degrees, reach));
        for (const Face face : mesh.faces())
            if (kept[face])
                for (const Vertex v : face_corners(mesh, face)) found.is_corner[v] = 1;
        for (const std::vector<Vertex>& some : found.coincident)
            if (std::ranges::any_of(some, [&](Vertex v) { return found.is_corner[v] != 0; }))
                for (const Vertex v : some) found.is_corner[v] = 1;
    }

    FeatureLines trace() {
        for (const Vertex v : mesh.vertices())
            if (found.is_corner[v])
                for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
                    if (is_new(h)) add_line(chain(mesh.opposite(h)));
        // Remaining lines have no corner: they are closed, and begin and end at any of their vertices.
        for (const Edge edge : mesh.edges()) {
            const Halfedge h = mesh.halfedge(edge);
            if (!is_new(h)) continue;
            const Halfedge begin = shared[edge] ? first_of(chain(h)) : h;
            found.is_corner[mesh.source(begin)] = 1;
            add_line(chain(begin));
        }
        return std::move(found);
    }

  private:
    bool is_new(Halfedge h) const {
        const Edge edge = mesh.edge(h);
        return marks[edge] && found.of_edge[edge].line == LineStretch::none;
    }

    /// Returns the marked edges at a vertex, as halfedges that leave it.
    std::vector<Halfedge> marked_from(Vertex v) const {
        std::vector<Halfedge> leaving;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
            if (marks[mesh.edge(h)]) leaving.push_back(mesh.opposite(h));
        return leaving;
    }

    /// Returns the first vertex on the line that begins with h whose distance from the beginning is `reach`
    /// (m) or more; or the end of the line.
    Vertex ahead(Halfedge h, double reach) const {
        const Vertex begin = mesh.source(h);
        while ((position(mesh, mesh.target(h)) - position(mesh, begin)).norm() < reach) {
            const std::vector<Halfedge> next = marked_from(mesh.target(h));
            if (next.size() != 2) break;
            h = next[0] == mesh.opposite(h) ? next[1] : next[0];
            if (mesh.target(h) == begin) break;
        }
        return mesh.target(h);
    }

    bool is_corner(Vertex v, double degrees, double reach) const {
        const std::vector<Halfedge> leaving = marked_from(v);
        if (leaving.size() != 2) return !leaving.empty();
        if (shared[mesh.edge(leaving[0])] != shared[mesh.edge(leaving[1])]) return true;
        const double straight = std::cos(degrees * std::numbers::pi / 180);
        const auto turns = [&](Vertex a, Vertex b) {
            const Vector3d here = position(mesh, v);
            return -(position(mesh, a) - here).normalized().dot((position(mesh, b) - here).normalized()) <
                   straight;
        };
        return turns(mesh.target(leaving[0]), mesh.target(leaving[1])) &&
               turns(ahead(leaving[0], reach), ahead(leaving[1], reach));
    }

    /// Returns the halfedges of the line that begins with h, up to a corner, or back to where the line began.
    std::vector<Halfedge> chain(Halfedge h) const {
        std::vector<Halfedge> all{h};
        while (!found.is_corner[mesh.target(h)] && mesh.target(h) != mesh.source(all.front())) {
            const std::vector<Halfedge> next = marked_from(mesh.target(h));
            h = next[0] == mesh.opposite(h) ? next[1] : next[0];
            all.push_back(h);
        }
        return all;
    }

    /// Returns the halfedge of a closed line that leaves the first point of the line in the order of
    /// coordinates.
    Halfedge first_of(const std::vector<Halfedge>& closed) const {
        return *std::ranges::min_element(closed, {}, [&](Halfedge h) { return mesh.point(mesh.source(h)); });
    }

    std::vector<Vertex> vertices_of(const std::vector<Halfedge>& halfedges) const {
        std::vector<Vertex> vertices{mesh.source(halfedges.front())};
        for (const Halfedge h : halfedges) vertices.push_back(mesh.target(h));
        return vertices;
    }

    /// Reverses a shared line if its last points come before its first ones in the order of coordinates, so
    /// that the line is the same on all sheets.
    void orient(std::vector<Halfedge>& halfedges) const {
        const std::vector<Vertex> there = vertices_of(halfedges), back(there.rbegin(), there.rend());
        const auto before = [&](Vertex a, Vertex b) { return mesh.point(a) < mesh.point(b); };
        if (!std::ranges::lexicographical_compare(back, there, before)) return;
        std::ranges::reverse(halfedges);
        for (Halfedge& h : halfedges) h = mesh.opposite(h);
    }

    void add_line(std::vector<Halfedge> halfedges) {
        const auto number = static_cast<std::int32_t>(found.lines.size());
        FeatureLine line;
        line.is_shared = shared[mesh.edge(halfedges.front())] != 0;
        if (line.is_shared) orient(halfedges);
        line.vertices = vertices_of(halfedges);
        for (const Vertex v : line.vertices) line.points.push_back(position(mesh, v));
        line.along.push_back(0);
        for (const Halfedge h : halfedges) {
            const double before = line.length();
            line.along.push_back(before + length_of(mesh, mesh.edge(h)));
            found.of_edge[mesh.edge(h)] = {number, mesh.source(h), mesh.target(h), before, line.length()};
        }
        found.lines.push_back(std::move(line));
    }

    const Mesh& mesh;
    const EdgeMarks &marks, &shared;
    FeatureLines found;
};

}  // namespace

std::vector<Face> faces_near(const Mesh& mesh, std::vector<Face> near, const Vector3d& place, double reach) {
    constexpr std::size_t most = 64;
    for (std::size_t i = 0; i < near.size() && near.size() < most; ++i)
        for (const Halfedge side : mesh.halfedges_around_face(mesh.halfedge(near[i]))) {
            const Face next = mesh.face(mesh.opposite(side));
            if (next == Mesh::null_face() || std::ranges::find(near, next) != near.end()) continue;
            if ((centroid(mesh, next) - place).norm() < reach) near.push_back(next);
        }
    return near;
}

Vector3d FeatureLine::at(double way) const {
    const auto after = std::ranges::upper_bound(along, way);
    const auto i = std::clamp<std::ptrdiff_t>(after - along.begin(), 1, std::ssize(along) - 1);
    const double part = std::clamp((way - along[i - 1]) / (along[i] - along[i - 1]), 0.0, 1.0);
    return (1 - part) * points[i - 1] + part * points[i];
}

FeatureLines feature_lines(const Mesh& mesh, double degrees, double edge_length,
                           const std::vector<char>& kept) {
    const SharedEdges shared = shared_edges(mesh);
    const EdgeMarks marks = marked_edges(mesh, degrees, edge_length, kept, shared.is_shared);
    return LineTracing(mesh, marks, degrees, edge_length / 3, kept, shared).trace();
}

}  // namespace sherd
