// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/remeshing.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/mesh_measures.h"
#include "meshops/remesh/plain_copy.h"

namespace sherd {

using Eigen::Vector3d;

Remeshing::Remeshing(const InputSurface& surface, const SizeField& sizes, const std::vector<double>& unsplit)
    : surface(surface), sizes(sizes), work(plain_copy(surface.mesh)) {
    site = work.add_property_map<Vertex, Site>("v:site").first;
    stretch = work.add_property_map<Edge, LineStretch>("e:stretch").first;
    whole = work.add_property_map<Edge, double>("e:whole", 0).first;
    for (const Edge edge : surface.mesh.edges()) {
        // The copy numbers its edges anew.
        const LineStretch& of = surface.lines.of_edge[edge];
        const Vertex a = surface.mesh.vertex(edge, 0), b = surface.mesh.vertex(edge, 1);
        const Edge copy = work.edge(work.halfedge(a, b));
        if (of.line != LineStretch::none) stretch[copy] = of;
        for (const Halfedge h : {surface.mesh.halfedge(edge, 0), surface.mesh.halfedge(edge, 1)})
            if (!surface.mesh.is_border(h))
                whole[copy] = std::max(whole[copy], unsplit[surface.mesh.face(h)]);
    }
    for (const Vertex v : work.vertices()) {
        site[v].is_fixed = surface.lines.is_corner[v] != 0;
        for (const Face face : work.faces_around_target(work.halfedge(v)))
            if (face != Mesh::null_face()) site[v].face = face;
    }
    for (const Edge edge : work.edges())
        if (is_line(edge))
            for (const int end : {0, 1}) site[work.vertex(edge, end)].is_on_line = true;
    update_sizes();
    fix_shared_lines();
}

/// Fixes vertices of shared lines at distances of about the target length, at the same places on all sheets.
/// Other vertices between them are removed by collapses, and longer edges are halved.
void Remeshing::fix_shared_lines() {
    constexpr double shortest = 0.75, shortest_last = 0.5;  // target lengths
    for (const FeatureLine& line : surface.lines.lines) {
        if (!line.is_shared) continue;
        double last = 0;
        for (std::size_t i = 1; i + 1 < line.vertices.size(); ++i) {
            const Vertex v = line.vertices[i];
            const double size = site[v].size;
            if (line.along[i] - last < shortest * size ||
                line.length() - line.along[i] < shortest_last * size)
                continue;
            site[v].is_fixed = true;
            last = line.along[i];
        }
    }
}

void Remeshing::update_sizes() {
    for (const Vertex v : work.vertices()) place_at(v, surface.nearest(site[v].face, position(work, v)));
}

void Remeshing::improve(int rounds) {
    constexpr int smoothings = 2, mendings = 4;
    constexpr double perturbation = 0.5;
    for (int round = 0; round < rounds; ++round) {
        split_long();
        collapse_short();
        flip_edges();
        if (round < rounds / 2) move_vertices(perturbation);
        for (int i = 0; i < smoothings; ++i) move_vertices();
    }
    for (int i = 0; i < mendings; ++i) {
        improve_angles();
        flip_edges();
        move_vertices();
    }
}

void Remeshing::split_long() {
    constexpr int sweeps = 24;           // each sweep halves long edges: enough for any length
    constexpr double longest = 4.0 / 3;  // target lengths
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        bool is_done = true;
        for (const Edge edge : edges_by_length(true)) {
            const double most = longest * target_length(work.vertex(edge, 0), work.vertex(edge, 1));
            if (length(edge) <= std::max(most, whole[edge])) continue;
            split(edge);
            is_done = false;
        }
        if (is_done) break;
    }
}

void Remeshing::split(Edge edge) {
    const Halfedge h = work.halfedge(edge);
    const Vertex a = work.source(h), b = work.target(h);
    const Vector3d middle = (position(work, a) + position(work, b)) / 2;
    const LineStretch was = stretch[edge];
    const Halfedge half = CGAL::Euler::split_edge(h, work);
    const Vertex v = work.target(half);
    for (Halfedge g : {half, work.opposite(h)}) {
        if (work.is_border(g)) continue;
        const Halfedge across = CGAL::Euler::split_face(g, work.next(work.next(g)), work);
        stretch[work.edge(across)] = {};
    }
    site[v] = {.face = site[a].face, .is_on_line = was.line != LineStretch::none};
    stretch[work.edge(half)] = stretch[edge] = {};
    whole[work.edge(half)] = whole[edge];
    Vector3d near = middle;
    if (was.line != LineStretch::none) {
        const double way = (was.at_begin + was.at_end) / 2;
        near = surface.lines.lines[was.line].at(way);
        site[v].is_fixed = surface.lines.lines[was.line].is_shared;
        const bool begins = was.begin == a;
        set_line(work.edge(half), v, {a, was.line, way, begins ? was.at_begin : was.at_end});
        set_line(edge, v, {b, was.line, way, begins ? was.at_end : was.at_begin});
    }
    const InputSurface::Site found = below_edge(a, b, near);
    place_at(v, found);
    const Vector3d place = was.line == LineStretch::none ? found.place : near;
    const bool is_given = site[v].is_fixed;  // a shared line gives the place
    work.point(v) = point_at(is_given || fits(v, place, 0) ? place : middle);
}

/// Returns the point of the surface nearest to `near`, a point at the edge between a and b. The search begins
/// at an end that is on no line, since the face of an end on a line may be on the other side of the line.
InputSurface::Site Remeshing::below_edge(Vertex a, Vertex b, const Vector3d& near) const {
    if (!site[a].is_on_line) return surface.nearest(site[a].face, near, false);
    if (!site[b].is_on_line) return surface.nearest(site[b].face, near, false);
    const InputSurface::Site from_a = surface.nearest(site[a].face, near);
    const InputSurface::Site from_b = surface.nearest(site[b].face, near);
    return (from_a.place - near).squaredNorm() <= (from_b.place - near).squaredNorm() ? from_a : from_b;
}

void Remeshing::flip_edges() {
    constexpr int sweeps = 3;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        std::size_t count = 0;
        for (const Edge edge : edges_by_length(true)) count += flip(edge) ? 1 : 0;
        if (count == 0) break;
    }
}

bool Remeshing::flip(Edge edge) {
    if (is_line(edge) || work.is_border(edge)) return false;
    const Halfedge h = work.halfedge(edge), g = work.opposite(h);
    const Vertex a = work.source(h), b = work.target(h);
    const Vertex c = work.target(work.next(h)), d = work.target(work.next(g));
    if (c == d || work.halfedge(c, d) != Mesh::null_halfedge()) return false;
    const Vector3d pa = position(work, a), pb = position(work, b), pc = position(work, c),
                   pd = position(work, d);
    const double before = std::min(sherd::smallest_angle({pa, pb, pc}), sherd::smallest_angle({pb, pa, pd}));
    const double after = std::min(sherd::smallest_angle({pc, pd, pb}), sherd::smallest_angle({pd, pc, pa}));
    constexpr double gain = 1e-3;
    if (after <= before + gain) return false;
    const Vector3d one = triangle_normal({pc, pd, pb}), other = triangle_normal({pd, pc, pa});
    const Vector3d old = triangle_normal({pa, pb, pc}) + triangle_normal({pb, pa, pd});
    constexpr double bent = 0.7;  // cosine
    if (one.dot(other) <= bent * one.norm() * other.norm() || one.dot(old) <= 0 || other.dot(old) <= 0)
        return false;
    if (!approximates_surface({c, d, b}, {pc, pd, pb}) || !approximates_surface({d, c, a}, {pd, pc, pa}))
        return false;
    CGAL::Euler::flip_edge(h, work);
    return true;
}

/// Moves vertices towards the mean of the centroids of the faces around them, weighted by area over squared
/// target length. perturbation: random displacement, in target lengths, which breaks the order of a mesh that
/// was a grid.
void Remeshing::move_vertices(double perturbation) {
    constexpr double fine_angle = 32 * degree;  // rad: angles may decrease down to this
    for (const Vertex v : work.vertices()) {
        if (site[v].is_fixed) continue;
        const double least = std::min(angle_at(v), fine_angle);
        if (site[v].is_on_line) {
            slide(v, 1, least) || slide(v, 0.5, least);
            continue;
        }
        Vector3d sum = Vector3d::Zero();
        double weight = 0;
        for (const Face face : work.faces_around_target(work.halfedge(v))) {
            double size = 0;
            for (const Vertex corner : face_corners(work, face)) size += site[corner].size / 3;
            const double area = face_area(work, face) / (size * size);
            sum += area * centroid(work, face);
            weight += area;
        }
        if (!(weight > 0)) continue;
        const Vector3d here = position(work, v);
        Vector3d there = sum / weight;
        for (int i = 0; i < 3 && perturbation > 0; ++i)
            there[i] += perturbation * site[v].size * (2 * random.uniform() - 1);
        move(v, there, least) || move(v, (here + there) / 2, least);
    }
}

/// Moves a vertex to the point of the surface nearest to `to`, without crossing lines, if fits() allows this.
/// Returns whether it was moved.
bool Remeshing::move(Vertex v, const Vector3d& to, double least_angle) {
    const InputSurface::Site found = surface.nearest(site[v].face, to, false);
    if (!fits(v, found.place, least_angle)) return false;
    work.point(v) = point_at(found.place);
    place_at(v, found);
    return true;
}

/// Moves a vertex along its line, by the fraction `part` of the distance to the middle between its neighbours
/// on the line, if fits() allows this. Returns whether it was moved.
bool Remeshing::slide(Vertex v, double part, double least_angle) {
    const std::vector<LineEnd> ends = line_ends(v);
    if (ends.size() != 2 || ends[0].line != ends[1].line) return false;
    const double middle = (ends[0].at_other + ends[1].at_other) / 2;
    const double way = ends[0].at_vertex + part * (middle - ends[0].at_vertex);
    const Vector3d place = surface.lines.lines[ends[0].line].at(way);
    if (!fits(v, place, least_angle)) return false;
    work.point(v) = point_at(place);
    for (const LineEnd& end : ends)
        set_line(work.edge(work.halfedge(v, end.other)), v, {end.other, end.line, way, end.at_other});
    place_at(v, surface.nearest(site[v].face, place));
    return true;
}

/// Whether a vertex may move to `place`: no face around it turns away from its earlier normal or from the
/// surface, and no angle falls below `least_angle`.
bool Remeshing::fits(Vertex v, const Vector3d& place, double least_angle) const {
    for (const Face face : work.faces_around_target(work.halfedge(v))) {
        if (face == Mesh::null_face()) continue;
        const std::array<Vertex, 3> corners = face_corners(work, face);
        const Triangle before = face_points(work, face);
        Triangle after = before;
        after[corner_number(corners, v)] = place;
        const Vector3d was = triangle_normal(before), is = triangle_normal(after);
        if (is.dot(was) < 0 || sherd::smallest_angle(after) < least_angle ||
            !approximates_surface(corners, after))
            return false;
    }
    return true;
}

std::vector<Edge> Remeshing::edges_by_length(bool longest_first) const {
    std::vector<std::pair<double, Edge>> sorted;
    for (const Edge edge : work.edges())
        sorted.emplace_back(longest_first ? -length(edge) : length(edge), edge);
    std::ranges::sort(sorted);
    std::vector<Edge> edges;
    edges.reserve(sorted.size());
    for (const auto& [unused, edge] : sorted) edges.push_back(edge);
    return edges;
}

double Remeshing::length(Edge edge) const {
    return (position(work, work.vertex(edge, 0)) - position(work, work.vertex(edge, 1))).norm();
}

std::vector<Remeshing::LineEnd> Remeshing::line_ends(Vertex v) const {
    std::vector<LineEnd> ends;
    for (const Halfedge h : work.halfedges_around_target(work.halfedge(v))) {
        const LineStretch& part = stretch[work.edge(h)];
        if (part.line == LineStretch::none) continue;
        const bool begins = part.begin == v;
        ends.push_back({work.source(h), part.line, begins ? part.at_begin : part.at_end,
                        begins ? part.at_end : part.at_begin});
    }
    return ends;
}

void Remeshing::set_line(Edge edge, Vertex v, const LineEnd& end) {
    stretch[edge] = {end.line, v, end.other, end.at_vertex, end.at_other};
}

/// Returns the smallest angle of the faces around a vertex, rad.
double Remeshing::angle_at(Vertex v) const {
    double least = std::numbers::pi;
    for (const Face face : work.faces_around_target(work.halfedge(v)))
        if (face != Mesh::null_face())
            least = std::min(least, sherd::smallest_angle(face_points(work, face)));
    return least;
}

/// Whether the normal of a triangle agrees with the normal of the surface at each corner that is on no line.
bool Remeshing::approximates_surface(const std::array<Vertex, 3>& corners, const Triangle& places) const {
    constexpr double away = 0.5;  // cosine
    const Vector3d normal = triangle_normal(places);
    const double area = normal.norm();
    return area > 0 && std::ranges::all_of(corners, [&](Vertex v) {
               return site[v].is_on_line || normal.dot(surface.normal(site[v].face)) > away * area;
           });
}

void Remeshing::place_at(Vertex v, const InputSurface::Site& at) {
    site[v].face = at.face;
    site[v].size = sizes.at(at);
}

}  // namespace sherd
