// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/boost/graph/Euler_operations.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "meshops/mesh_measures.h"
#include "meshops/remesh/remeshing.h"

namespace sherd {

using Eigen::Vector3d;

void Remeshing::collapse_short() {
    constexpr double shortest = 0.8, slack = 4.0 / 3, least_angle = 12 * degree;
    for (const Edge edge : edges_by_length(false)) {
        if (work.is_removed(edge)) continue;
        const Halfedge h = work.halfedge(edge), g = work.opposite(h);
        if (length(edge) >= shortest * target_length(work.source(h), work.target(h))) continue;
        if (may_collapse(h, slack, least_angle))
            collapse(h);
        else if (may_collapse(g, slack, least_angle))
            collapse(g);
    }
}

/// Whether the source of h may be moved to its target: then no edge is longer than `slack` times the target
/// length, and no angle falls below `least_angle` or, if that is smaller, below the smallest angle before.
bool Remeshing::may_collapse(Halfedge h, double slack, double least_angle) const {
    const Vertex gone = work.source(h), stays = work.target(h);
    if (!keeps_lines(h) || !CGAL::Euler::does_satisfy_link_condition(work.edge(h), work)) return false;
    const Vector3d place = position(work, stays);
    const double least = std::min(least_angle, angle_at(gone));
    for (const Halfedge g : work.halfedges_around_target(work.halfedge(gone))) {
        const Vertex other = work.source(g);
        if ((position(work, other) - place).norm() > slack * target_length(other, stays)) return false;
        const Face face = work.face(g);
        if (face == Mesh::null_face()) continue;
        std::array<Vertex, 3> corners = face_corners(work, face);
        if (corner_number(corners, stays) < 3) continue;
        const std::size_t moved = corner_number(corners, gone);
        const Triangle before = face_points(work, face);
        Triangle after = before;
        after[moved] = place;
        corners[moved] = stays;
        const Vector3d was = triangle_normal(before), is = triangle_normal(after);
        constexpr double turned = 0.5;  // cosine
        if (is.dot(was) < turned * is.norm() * was.norm() || sherd::smallest_angle(after) < least ||
            !approximates_surface(corners, after))
            return false;
    }
    return true;
}

/// Whether the source of h may be moved to its target without bending a line or joining two lines.
bool Remeshing::keeps_lines(Halfedge h) const {
    const Vertex gone = work.source(h), stays = work.target(h);
    if (site[gone].is_fixed || (site[gone].is_on_line && !is_line(work.edge(h)))) return false;
    for (const Halfedge side : {h, work.opposite(h)}) {
        if (work.is_border(side)) continue;
        const Vertex apex = work.target(work.next(side));
        if (is_line(work.edge(work.halfedge(gone, apex))) && is_line(work.edge(work.halfedge(stays, apex))))
            return false;
    }
    return true;
}

void Remeshing::collapse(Halfedge h) {
    const Vertex gone = work.source(h), stays = work.target(h);
    const Point place = work.point(stays);
    const Site kept = site[stays];
    // Edges of lines at both vertices, with the merged vertex as their end.
    std::vector<LineEnd> ends;
    double here = 0;
    for (const LineEnd& end : line_ends(stays))
        if (end.other != gone)
            ends.push_back(end);
        else
            here = end.at_vertex;
    for (const LineEnd& end : line_ends(gone))
        if (end.other != stays) ends.push_back({end.other, end.line, here, end.at_other});
    const Vertex left = CGAL::Euler::collapse_edge(work.edge(h), work);
    work.point(left) = place;
    site[left] = kept;
    for (const Halfedge g : work.halfedges_around_target(work.halfedge(left))) stretch[work.edge(g)] = {};
    for (const LineEnd& end : ends) set_line(work.edge(work.halfedge(left, end.other)), left, end);
}

void Remeshing::improve_angles() {
    constexpr double small = 25 * degree;
    std::vector<std::pair<double, Face>> sorted;
    for (const Face face : work.faces())
        if (const double angle = sherd::smallest_angle(face_points(work, face)); angle < small)
            sorted.emplace_back(angle, face);
    std::ranges::sort(sorted);
    for (const auto& [angle, face] : sorted)
        if (!work.is_removed(face) && sherd::smallest_angle(face_points(work, face)) < small)
            improve_face(face);
}

/// Flips the longest edge of a face, collapses its shortest one, or moves a corner, if that makes its angles
/// larger. Returns whether the mesh has changed.
bool Remeshing::improve_face(Face face) {
    const auto around = work.halfedges_around_face(work.halfedge(face));
    std::vector<Halfedge> sides(around.begin(), around.end());
    std::ranges::sort(sides, {}, [&](Halfedge h) { return length(work.edge(h)); });
    if (flip(work.edge(sides.back()))) return true;
    constexpr double slack = 1.6, least_angle = 25 * degree;
    for (const Halfedge h : {sides.front(), work.opposite(sides.front())})
        if (may_collapse(h, slack, least_angle)) return collapse(h), true;
    for (const Vertex v : face_corners(work, face)) {
        if (site[v].is_fixed || site[v].is_on_line) continue;
        const double least = angle_at(v) + 1e-3;
        for (const Face at : work.faces_around_target(work.halfedge(v)))
            if (move(v, (position(work, v) + centroid(work, at)) / 2, least)) return true;
    }
    return false;
}

}  // namespace sherd
