// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/obstacles.h"

#include <fmt/format.h>

#include "app/scene/build/deforming_mesh.h"
#include "app/scene/build/grid_shape.h"
#include "app/scene/build/mesh.h"
#include "app/scene/build/obstacle_facets.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double voxels_along = 100;  // the diagonal of a mesh: half a million voxels or less
constexpr double sagitta = 0.05;  // of the thinnest sheet's thickness: what facets lie inside round shapes

/// An obstacle's shape, with what follows from it.
struct Made {
    std::shared_ptr<const Shape> shape;
    ColliderSurface surface;
    std::shared_ptr<const Deformation> deformation = nullptr;
};

template <class Solid>
Made make(const Solid& solid, const ThicknessRange& sheets, std::vector<std::string>&) {
    return {std::make_shared<Solid>(solid), facets(solid, sagitta * sheets.thinnest)};
}

Made make(const ObstacleMesh& spec, const ThicknessRange& sheets, std::vector<std::string>& warnings) {
    if (spec.cache) {
        DeformingMesh made = make_deforming_mesh(spec, warnings);
        return {std::make_shared<BareSurface>(), std::move(made.surface),
                std::make_shared<Deformation>(std::move(made.deformation))};
    }
    const Mesh mesh = read_mesh(spec.file, warnings);
    const MeshMeasures extent = measure(mesh);
    const double voxel = spec.voxel > 0 ? spec.voxel : (extent.upper - extent.lower).norm() / voxels_along;
    if (extent.boundary_loops > 0)
        warnings.push_back(fmt::format("{} has {} holes; those of up to about a voxel, {:.3g} m, are closed",
                                       spec.file.path.string(), extent.boundary_loops, voxel));
    return with_context(spec.file.path.string(), [&]() -> Made {
        return {std::make_shared<GridShape>(SignedDistanceGrid::of_mesh(mesh, voxel, 0.5 * sheets.thickest)),
                facets(mesh)};
    });
}

Made make(const ObstacleLevelSet& spec, const ThicknessRange& sheets, std::vector<std::string>&) {
    const auto shape = std::make_shared<GridShape>(
        SignedDistanceGrid::of_level_set(spec.path, spec.name, spec.scale, 0.5 * sheets.thickest));
    return {shape, facets(shape->grid.surface())};
}

std::shared_ptr<const ColliderSurface> shared(ColliderSurface surface) {
    return surface.size() == 0 ? nullptr : std::make_shared<ColliderSurface>(std::move(surface));
}

}  // namespace

std::vector<Obstacle> make_obstacles(const std::vector<ObstacleSpec>& specs, const ThicknessRange& sheets,
                                     std::vector<std::string>& warnings) {
    std::vector<Obstacle> obstacles;
    for (const ObstacleSpec& spec : specs) {
        std::vector<std::string> found;
        Made made = with_context(spec.where, [&] {
            return std::visit([&](const auto& kind) { return make(kind, sheets, found); }, spec.shape);
        });
        for (const std::string& warning : found)
            warnings.push_back(fmt::format("{}: {}", spec.where, warning));
        obstacles.push_back(
            {{std::move(made.shape), shared(std::move(made.surface)), spec.young, spec.friction},
             spec.motion,
             std::move(made.deformation)});
    }
    return obstacles;
}

std::vector<RigidBody> make_bodies(const Scene& scene, const ThicknessRange& sheets) {
    std::vector<RigidBody> bodies;
    for (const ObstacleSpec& spec : scene.bodies) {
        const auto* sphere = std::get_if<SphereShape>(&spec.shape);
        RigidBody body = sphere ? rigid_sphere(sphere->radius, spec.free->density)
                                : rigid_box(2 * std::get<BoxShape>(spec.shape).half, spec.free->density);
        // Like the shape, about the centre of mass and along the principal axes.
        body.surface =
            shared(sphere ? facets(SphereShape(Vector3d::Zero(), sphere->radius), sagitta * sheets.thinnest)
                          : facets(BoxShape(Vector3d::Zero(), std::get<BoxShape>(spec.shape).half), 0));
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

}  // namespace sherd
