// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/obstacle_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "app/scene/scene_mesh.h"
#include "fracture/grid_shape.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double voxels_along = 100;  // the diagonal of a mesh: half a million voxels or less
constexpr int segments = 48;          // of a circle that is drawn

using ShapePointer = std::shared_ptr<const Shape>;

template <class Solid>
ShapePointer make(const Solid& solid, double, std::vector<std::string>&) {
    return std::make_shared<Solid>(solid);
}

ShapePointer make(const ObstacleMesh& spec, double reach, std::vector<std::string>& warnings) {
    const Mesh mesh = read_mesh(spec.file, warnings);
    const MeshMeasures extent = measure(mesh);
    const double voxel = spec.voxel > 0 ? spec.voxel : (extent.upper - extent.lower).norm() / voxels_along;
    if (extent.boundary_loops > 0)
        warnings.push_back(fmt::format("{} has {} holes; those of up to about a voxel, {:.3g} m, are closed",
                                       spec.file.path.string(), extent.boundary_loops, voxel));
    return with_context(spec.file.path.string(), [&] {
        return std::make_shared<GridShape>(SignedDistanceGrid::of_mesh(mesh, voxel, reach));
    });
}

ShapePointer make(const ObstacleLevelSet& spec, double reach, std::vector<std::string>&) {
    return std::make_shared<GridShape>(
        SignedDistanceGrid::of_level_set(spec.path, spec.name, spec.scale, reach));
}

/// A closed profile of (r, z), from its lower end on the axis to its upper one, turned about the z axis.
GridSurface revolved(const std::vector<Vector2d>& profile) {
    GridSurface surface;
    for (const Vector2d& p : profile)
        for (int i = 0; i < segments; ++i) {
            const double angle = 2 * std::numbers::pi * i / segments;
            surface.points.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
        }
    for (int row = 0; row + 1 < static_cast<int>(profile.size()); ++row)
        for (int i = 0; i < segments; ++i) {
            const int a = row * segments + i, b = row * segments + (i + 1) % segments;
            if (profile[row].x() > 0) surface.triangles.push_back({a, b, b + segments});
            if (profile[row + 1].x() > 0) surface.triangles.push_back({a, b + segments, a + segments});
        }
    return surface;
}

void transform(GridSurface& surface, const Eigen::Affine3d& map) {
    for (Vector3d& p : surface.points) p = map * p;
}

GridSurface draw(const SphereShape& sphere) {
    std::vector<Vector2d> profile{{0, -sphere.radius}};
    for (int i = 1; i < segments / 2; ++i) {
        const double angle = std::numbers::pi * i / (segments / 2);
        profile.emplace_back(sphere.radius * std::sin(angle), -sphere.radius * std::cos(angle));
    }
    profile.emplace_back(0, sphere.radius);
    GridSurface surface = revolved(profile);
    transform(surface, Eigen::Affine3d(Eigen::Translation3d(sphere.centre)));
    return surface;
}

GridSurface draw(const CylinderShape& cylinder) {
    const double r = cylinder.radius, z = cylinder.length / 2;
    GridSurface surface = revolved({{0, -z}, {r, -z}, {r, z}, {0, z}});
    transform(surface, Eigen::Translation3d(cylinder.centre) *
                           Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), cylinder.axis));
    return surface;
}

GridSurface draw(const BoxShape& box) {
    GridSurface surface;
    for (int i = 0; i < 8; ++i)
        surface.points.push_back(
            box.centre + box.half.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    for (const auto& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4}, std::array{2, 6, 7, 3},
          std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
        surface.triangles.push_back({a, b, c});
        surface.triangles.push_back({a, c, d});
    }
    return surface;
}

double thickest_half(const Scene& scene) {
    double largest = 0;
    for (const SheetSpec& sheet : scene.sheets) largest = std::max(largest, 0.5 * sheet.material.thickness);
    return largest;
}

}  // namespace

std::vector<Obstacle> make_obstacles(const Scene& scene, const std::vector<ObstacleSpec>& specs,
                                     std::vector<std::string>& warnings) {
    std::vector<Obstacle> obstacles;
    for (const ObstacleSpec& spec : specs) {
        std::vector<std::string> found;
        const ShapePointer shape = with_context(spec.where, [&] {
            return std::visit([&](const auto& kind) { return make(kind, thickest_half(scene), found); },
                              spec.shape);
        });
        for (const std::string& warning : found)
            warnings.push_back(fmt::format("{}: {}", spec.where, warning));
        obstacles.push_back({shape, spec.motion, spec.young, spec.friction});
    }
    return obstacles;
}

std::vector<RigidBody> make_bodies(const Scene& scene) {
    std::vector<RigidBody> bodies;
    for (const ObstacleSpec& spec : scene.bodies) {
        const auto* sphere = std::get_if<SphereShape>(&spec.shape);
        RigidBody body = sphere ? rigid_sphere(sphere->radius, spec.free->density)
                                : rigid_box(2 * std::get<BoxShape>(spec.shape).half, spec.free->density);
        body.young = spec.young;
        body.friction = spec.friction;
        body.centre = spec.motion.pivot;
        body.rotation = spec.motion.place.linear();
        body.velocity = spec.free->velocity;
        body.angular_momentum = body.inertia_in_space() * spec.free->spin;
        bodies.push_back(body);
    }
    return bodies;
}

GridSurface obstacle_surface(const ObstacleSpec& spec, const Obstacle& made) {
    if (std::holds_alternative<PlaneShape>(spec.shape)) return {};
    if (const auto* sphere = std::get_if<SphereShape>(&spec.shape)) return draw(*sphere);
    if (const auto* box = std::get_if<BoxShape>(&spec.shape)) return draw(*box);
    if (const auto* cylinder = std::get_if<CylinderShape>(&spec.shape)) return draw(*cylinder);
    return dynamic_cast<const GridShape&>(*made.shape).grid.surface();
}

}  // namespace sherd
