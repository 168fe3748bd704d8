// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>

#include "core/contact/colliders/obstacle.h"
#include "core/contact/geometry/basic_shapes.h"
#include "core/shell/shell.h"

namespace sherd::test {

template <class Solid>
Obstacle obstacle(const Solid& solid, double young = 3e10, double friction = 0) {
    return {{std::make_shared<Solid>(solid), nullptr, young, friction}, {}};
}

/// Plane z = 0.
inline Obstacle floor(double young = 3e10, double friction = 0) {
    return obstacle(PlaneShape{}, young, friction);
}

/// Rotation that makes a cube stand on a corner: the direction (1, 1, 1) becomes vertical.
inline Matrix3d onto_a_corner() {
    return Eigen::AngleAxisd(std::acos(1 / std::sqrt(3.0)), Vector3d(1, -1, 0).normalized()).matrix();
}

/// Surface of a box, made of twelve triangles. centre, half (from the centre to the sides): m.
inline std::shared_ptr<const ColliderSurface> box_surface(const Vector3d& centre, const Vector3d& half) {
    Positions points(3, 8);
    for (int i = 0; i < 8; ++i)
        points.col(i) = centre + half.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    std::vector<std::array<Index, 3>> triangles;
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
          std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    return std::make_shared<ColliderSurface>(collider_surface(points, triangles));
}

/// Obstacle in the shape of a box that also has its surface as triangles.
inline Obstacle solid_box(const Vector3d& centre, const Vector3d& half, double young = 3e10,
                          double friction = 0) {
    Obstacle box = obstacle(BoxShape(centre, half), young, friction);
    box.surface = box_surface(centre, half);
    return box;
}

/// Sphere about the origin, made from an octahedron by dividing each triangle into four, `times` times.
/// radius: m.
inline std::shared_ptr<const ColliderSurface> sphere_surface(double radius, int times) {
    std::vector<Vector3d> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<std::array<Index, 3>> triangles{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                                {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (; times > 0; --times) {
        std::map<std::pair<Index, Index>, Index> middles;
        const auto middle = [&](Index a, Index b) {
            const auto [found, is_new] = middles.try_emplace(std::minmax({a, b}), points.size());
            if (is_new) points.push_back((points[a] + points[b]).normalized());
            return found->second;
        };
        std::vector<std::array<Index, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const Index d = middle(a, b), e = middle(b, c), f = middle(c, a);
            for (const auto& part : {std::array{a, d, f}, {d, b, e}, {f, e, c}, {d, e, f}})
                finer.push_back(part);
        }
        triangles = finer;
    }
    Positions all(3, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) all.col(i) = radius * points[i];
    return std::make_shared<ColliderSurface>(collider_surface(all, triangles));
}

/// Sheet of a single vertex, which acts like a ball of mass 0.1 kg and diameter 1 cm.
inline Shell lone_vertex(const Vector3d& at) {
    Shell shell;
    resize_vertices(shell, 1);
    shell.position.col(0) = at;
    shell.rest = shell.position;
    shell.mass[0] = 0.1;
    shell.thickness[0] = 0.01;
    shell.young[0] = 1e7;
    shell.footprint[0] = 1e-4;
    return shell;
}

}  // namespace sherd::test
