// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/geometry/collider_surface.h"

#include <Eigen/Geometry>
#include <stdexcept>
#include <string>

#include "core/contact/geometry/surface_edges.h"

namespace sherd {
namespace {

constexpr double flat = 1e-9;  // sine of the angle below which two triangles count as coplanar

/// Normal vector of a triangle, m^2; its length is twice the triangle's area.
Vector3d normal(const Positions& points, const std::array<Index, 3>& triangle) {
    const Vector3d origin = points.col(triangle[0]);
    return (points.col(triangle[1]) - origin).cross(points.col(triangle[2]) - origin);
}

bool in_one_plane(const Vector3d& a, const Vector3d& b) {
    return a.cross(b).norm() <= flat * a.norm() * b.norm() && a.dot(b) > 0;
}

}  // namespace

ColliderSurface collider_surface(Positions points, std::vector<std::array<Index, 3>> triangles,
                                 bool deforms) {
    ColliderSurface surface;
    surface.footprint = VectorXd::Zero(points.cols());
    std::vector<Vector3d> normals;
    std::vector<double> areas;
    for (const auto& triangle : triangles) {
        for (const Index point : triangle)
            if (point < 0 || point >= points.cols())
                throw std::out_of_range("a triangle has point " + std::to_string(point) + " of " +
                                        std::to_string(points.cols()));
        normals.push_back(normal(points, triangle));
        areas.push_back(0.5 * normals.back().norm());
        for (const Index point : triangle) surface.footprint[point] += areas.back() / 3;
    }
    for (const SurfaceEdge& edge : surface_edges(triangles, areas)) {
        const auto [a, b] = edge.ends;
        const double length = (points.col(a) - points.col(b)).norm();
        const bool inner = !deforms && edge.triangles == 2 &&
                           in_one_plane(normals[edge.first_two[0]], normals[edge.first_two[1]]);
        if (inner || length == 0) continue;
        surface.edges.push_back(edge.ends);
        surface.width.push_back(edge.area / length);
    }
    surface.points = std::move(points);
    surface.triangles = std::move(triangles);
    return surface;
}

}  // namespace sherd
