// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/surface.h"

namespace sherd {
namespace {

using Eigen::Vector3d;
using Corners = std::array<std::size_t, 3>;
using Point2 = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
/// Where a face is, as far as borders have been looked at.
enum class Where : char { unknown, outside, inside };
using CreasedFace =
    CGAL::Triangulation_face_base_with_info_2<Where, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using CreasedDelaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, CreasedFace>>;

[[noreturn]] void fail() {
    throw Error("the mesh cannot be generated: edge_length is too large for the shape");
}

/// Makes edges that stay of the pairs. Fails where two of them cross, or one passes through a vertex.
void constrain(CreasedDelaunay& triangulation, const std::vector<CreasedDelaunay::Vertex_handle>& handle,
               const std::vector<std::array<std::size_t, 2>>& pairs) {
    try {
        for (const auto& [a, b] : pairs) triangulation.insert_constraint(handle[a], handle[b]);
    } catch (const CreasedDelaunay::Intersection_of_constraints_exception&) {
        fail();
    }
    for (const auto& [a, b] : pairs)
        if (!triangulation.is_edge(handle[a], handle[b])) fail();
}

/// Marks the faces outside and inside of the borders, from infinity on.
void mark(CreasedDelaunay& triangulation, std::vector<std::array<std::size_t, 2>> borders) {
    for (auto& [a, b] : borders)
        if (a > b) std::swap(a, b);
    std::ranges::sort(borders);
    const auto is_border = [&](CreasedDelaunay::Face_handle face, int side) {
        const auto [a, b] =
            std::minmax(face->vertex((side + 1) % 3)->info(), face->vertex((side + 2) % 3)->info());
        return std::ranges::binary_search(borders, std::array<std::size_t, 2>{a, b});
    };
    for (const auto face : triangulation.all_face_handles()) face->info() = Where::unknown;
    std::vector<CreasedDelaunay::Face_handle> open{triangulation.infinite_face()};
    open.back()->info() = Where::outside;
    while (!open.empty()) {
        const CreasedDelaunay::Face_handle face = open.back();
        open.pop_back();
        for (int side = 0; side < 3; ++side) {
            const CreasedDelaunay::Face_handle next = face->neighbor(side);
            if (next->info() != Where::unknown) continue;
            const bool outside = (face->info() == Where::outside) != is_border(face, side);
            next->info() = outside ? Where::outside : Where::inside;
            open.push_back(next);
        }
    }
}

/// Delaunay triangles, the one with the lowest vertex first. The vertex at infinity has the number after the
/// last vertex.
std::vector<Corners> triangulate(const Surface& surface, const SurfacePoints& points) {
    const std::size_t count = points.parameter.size();
    std::vector<std::pair<Point2, std::size_t>> chart;
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Vector2d place = surface.chart(points.parameter[i]);
        chart.emplace_back(Point2(place.x(), place.y()), i);
    }
    CreasedDelaunay triangulation;
    triangulation.insert(chart.begin(), chart.end());
    if (triangulation.number_of_vertices() != count || triangulation.dimension() != 2) fail();
    std::vector<CreasedDelaunay::Vertex_handle> handle(count);
    for (const auto v : triangulation.finite_vertex_handles()) handle[v->info()] = v;
    for (const auto& pairs : {points.creases, points.borders}) constrain(triangulation, handle, pairs);
    triangulation.infinite_vertex()->info() = count;
    if (!points.borders.empty()) mark(triangulation, points.borders);
    std::vector<Corners> result;
    for (const auto face : triangulation.all_face_handles()) {
        if (!points.is_closed && triangulation.is_infinite(face)) continue;
        if (!points.borders.empty() && face->info() == Where::outside) continue;
        Corners corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        if (std::ranges::max(corners) >= points.hole) result.push_back(corners);
    }
    std::ranges::sort(result);
    return result;
}

std::vector<Vector3d> positions(const Surface& surface, const SurfacePoints& points) {
    std::vector<Vector3d> result;
    for (const auto& parameter : points.parameter) result.push_back(surface.position(parameter));
    if (points.is_closed) result.push_back(points.closing_point);
    return result;
}

/// The smallest of all angles, rad.
double smallest_angle(const std::vector<Vector3d>& place, const std::vector<Corners>& triangles) {
    double smallest = std::numbers::pi;
    for (const Corners& corners : triangles) {
        for (int i = 0; i < 3; ++i) {
            const Vector3d& here = place[corners[i]];
            const Vector3d u = place[corners[(i + 1) % 3]] - here, v = place[corners[(i + 2) % 3]] - here;
            smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
        }
    }
    return smallest;
}

/// The common point of the Voronoi cells of three corners: the circumcentre or, in an obtuse triangle, the
/// point nearest to it, the middle of the longest side (which keeps a vertex's cell among its neighbours).
Vector3d cell_corner(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d u = b - a, v = c - a, n = u.cross(v);
    if (u.dot(v) <= 0) return (b + c) / 2;
    if (u.dot(u - v) <= 0) return (a + c) / 2;
    if (v.dot(v - u) <= 0) return (a + b) / 2;
    return a + (u.squaredNorm() * v.cross(n) + v.squaredNorm() * n.cross(u)) / (2 * n.squaredNorm());
}

/// Moves each free point to the centroid of its Voronoi cell, which is summed over triangles (Lloyd).
void move_to_centroids(const Surface& surface, const std::vector<Vector3d>& place,
                       const std::vector<Corners>& triangles, SurfacePoints& points) {
    std::vector<Vector3d> moment(place.size(), Vector3d::Zero());
    std::vector<double> weight(place.size(), 0);
    for (const Corners& corners : triangles) {
        const auto &a = place[corners[0]], &b = place[corners[1]], &c = place[corners[2]];
        const Vector3d meeting = cell_corner(a, b, c);
        // With the cells' common corner, each half of a side spans a part of a cell.
        for (int side = 0; side < 3; ++side) {
            const std::size_t i = corners[side], j = corners[(side + 1) % 3];
            const Vector3d middle = (place[i] + place[j]) / 2;
            const double area = (middle - place[i]).cross(meeting - place[i]).norm() / 2;
            weight[i] += area;
            weight[j] += area;
            moment[i] += area / 3 * (place[i] + middle + meeting);
            moment[j] += area / 3 * (place[j] + middle + meeting);
        }
    }
    for (std::size_t i = points.fixed; i < points.parameter.size(); ++i) {
        if (!(weight[i] > 0)) fail();  // it is in no triangle
        points.parameter[i] = surface.project(moment[i] / weight[i], points.parameter[i]);
    }
}

Mesh build(const std::vector<Vector3d>& place, const std::vector<Corners>& triangles) {
    Mesh mesh;
    for (const Vector3d& p : place) mesh.add_vertex(point_at(p));
    for (const Corners& corners : triangles) {
        std::array<Vertex, 3> face;
        std::ranges::transform(corners, face.begin(),
                               [](std::size_t i) { return Vertex(static_cast<Mesh::size_type>(i)); });
        if (mesh.add_face(face) == Mesh::null_face()) fail();
    }
    return mesh;
}

}  // namespace

Mesh relax(const Surface& surface, SurfacePoints points, int iterations) {
    // Occasionally a thin triangle remains: then the iteration continues, at most for as long again.
    constexpr double good_angle = 25 * std::numbers::pi / 180;
    for (int i = 0;; ++i) {
        const auto place = positions(surface, points);
        const auto triangles = triangulate(surface, points);
        const bool is_enough =
            i >= 2 * iterations || (i >= iterations && smallest_angle(place, triangles) >= good_angle);
        if (is_enough) return build(place, triangles);
        move_to_centroids(surface, place, triangles, points);
    }
}

}  // namespace sherd
