// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/error.h"
#include "meshops/generate/moving_delaunay.h"
#include "meshops/generate/surface.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector3d;
using Corners = MovingDelaunay::Corners;
std::vector<Vector3d> positions(const Surface& surface, const SurfacePoints& points) {
    std::vector<Vector3d> result;
    for (const auto& parameter : points.parameter) result.push_back(surface.position(parameter));
    if (points.is_closed) result.push_back(points.closing_point);
    return result;
}

/// Returns the smallest angle of all triangles, rad.
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

/// Returns the common point of the Voronoi cells of the three corners of a triangle: the circumcentre or, in
/// an obtuse triangle, the point of the triangle nearest to it, the middle of the longest side. (Thus the
/// cell of a vertex stays within the triangles at the vertex.)
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
        // Each half of a side spans, with the common point of the cells, a part of a cell.
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
        if (!(weight[i] > 0)) throw_generation_error();  // the point is in no triangle
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
        if (mesh.add_face(face) == Mesh::null_face()) throw_generation_error();
    }
    return mesh;
}

}  // namespace

Mesh relax(const Surface& surface, SurfacePoints points, int iterations) {
    // Occasionally a thin triangle remains: then up to as many iterations follow again.
    constexpr double good_angle = 25 * std::numbers::pi / 180;
    MovingDelaunay delaunay(surface, points);
    for (int i = 0;; ++i) {
        if (i > 0) delaunay.follow();
        const auto place = positions(surface, points);
        const auto triangles = delaunay.triangles();
        const bool is_enough =
            i >= 2 * iterations || (i >= iterations && smallest_angle(place, triangles) >= good_angle);
        if (is_enough) return build(place, triangles);
        move_to_centroids(surface, place, triangles, points);
    }
}

}  // namespace sherd
