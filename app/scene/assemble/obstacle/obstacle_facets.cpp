// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/obstacle/obstacle_facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr int fewest_segments = 48, most_segments = 192;  // for a circle

/// Returns an even number of segments for a circle (radius: m): so many that their sagitta is at most
/// `sagitta` (m), but at least fewest_segments and at most most_segments.
int segments_of(double radius, double sagitta) {
    const double half_angle = std::acos(std::clamp(1 - sagitta / radius, -1.0, 1.0));
    const double count = std::numbers::pi / std::max(half_angle, std::numbers::pi / most_segments);
    return std::max(fewest_segments, 2 * static_cast<int>(std::ceil(count / 2)));
}

/// Returns the surface of revolution of a profile of points (r, z), m, about the z axis, mapped by `map`. The
/// profile runs from its lower end to its upper end; both lie on the axis, and each is a single point of the
/// surface.
ColliderSurface revolved(const std::vector<Vector2d>& profile, int segments, const Eigen::Affine3d& map) {
    const int rows = static_cast<int>(profile.size()) - 2;
    Positions points(3, 2 + rows * segments);
    points.col(0) = map * Vector3d(0, 0, profile.front().y());
    points.col(1) = map * Vector3d(0, 0, profile.back().y());
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < segments; ++i) {
            const Vector2d& p = profile[row + 1];
            const double angle = 2 * std::numbers::pi * i / segments;
            points.col(2 + row * segments + i) =
                map * Vector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
        }
    std::vector<std::array<Index, 3>> triangles;
    for (int i = 0; i < segments; ++i) {
        const int next = (i + 1) % segments, last = 2 + (rows - 1) * segments;
        triangles.push_back({0, 2 + next, 2 + i});
        for (int row = 0; row + 1 < rows; ++row) {
            const int a = 2 + row * segments + i, b = 2 + row * segments + next;
            triangles.push_back({a, b, b + segments});
            triangles.push_back({a, b + segments, a + segments});
        }
        triangles.push_back({1, last + i, last + next});
    }
    return collider_surface(std::move(points), std::move(triangles));
}

}  // namespace

ColliderSurface facets(const PlaneShape&, double) {
    return {};
}

ColliderSurface facets(const SphereShape& sphere, double sagitta) {
    const int segments = segments_of(sphere.radius, sagitta);
    std::vector<Vector2d> profile;
    for (int i = 0; i <= segments / 2; ++i) {
        const double angle = 2 * std::numbers::pi * i / segments;
        profile.emplace_back(sphere.radius * std::sin(angle), -sphere.radius * std::cos(angle));
    }
    return revolved(profile, segments, Eigen::Affine3d(Eigen::Translation3d(sphere.centre)));
}

ColliderSurface facets(const CylinderShape& cylinder, double sagitta) {
    const double r = cylinder.radius, z = cylinder.length / 2;
    return revolved({{0, -z}, {r, -z}, {r, z}, {0, z}}, segments_of(r, sagitta),
                    Eigen::Translation3d(cylinder.centre) *
                        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), cylinder.axis));
}

ColliderSurface facets(const BoxShape& box, double) {
    Positions points(3, 8);
    for (int i = 0; i < 8; ++i)
        points.col(i) =
            box.centre + box.half.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    std::vector<std::array<Index, 3>> triangles;
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
          std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return collider_surface(std::move(points), std::move(triangles));
}

ColliderSurface facets(const Mesh& mesh) {
    Positions points(3, mesh.number_of_vertices());
    for (const Vertex vertex : mesh.vertices()) points.col(vertex) = position(mesh, vertex);
    std::vector<std::array<Index, 3>> triangles;
    for (const Face face : mesh.faces()) {
        std::array<Index, 3> corners;
        std::size_t i = 0;
        for (const Vertex vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            corners[i++] = static_cast<Index>(vertex);
        triangles.push_back(corners);
    }
    return collider_surface(std::move(points), std::move(triangles));
}

ColliderSurface facets(const GridSurface& surface) {
    Positions points(3, surface.points.size());
    for (std::size_t i = 0; i < surface.points.size(); ++i) points.col(i) = surface.points[i];
    return collider_surface(std::move(points), surface.triangles);
}

}  // namespace sherd
