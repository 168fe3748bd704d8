// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/obstacle/obstacles.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "app/scene/assemble/obstacle/deforming_mesh.h"
#include "app/scene/assemble/obstacle/obstacle_facets.h"
#include "app/scene/assemble/sheet/mesh.h"
#include "core/contact/geometry/shape.h"
#include "meshops/error.h"
#include "meshops/level_set/signed_distance_grid.h"
#include "meshops/mesh_measures.h"
#include "meshops/solid/solid_moments.h"

namespace sherd {
namespace {

/// A shape that is given by signed distances on a grid.
struct GridShape : Shape {
    SignedDistanceGrid grid;

    explicit GridShape(SignedDistanceGrid grid) : grid(std::move(grid)) {}
    SurfaceDistance distance(const Vector3d& at) const override {
        const SignedDistanceGrid::Sample sample = grid.sample(at);
        return {sample.distance, sample.gradient, sample.hessian};
    }
    Eigen::AlignedBox3d bounds() const override { return {grid.lower(), grid.upper()}; }
};

constexpr double voxels_along = 100;  // voxels along a mesh's diagonal: at most half a million in all
/// Least share of its bounding box that a solid fills. A mesh that fills less is flat, or its volume is
/// round-off.
constexpr double least_filled = 1e-9;
constexpr double sagitta = 0.05;  // largest sagitta of facets of round shapes, as a share of the thinnest
                                  // sheet's thickness

/// Requirements, m, of sheets and free balls on the shapes of obstacles: the largest sagitta of facets, and
/// the distance from the surface up to which signed distances are needed.
struct Need {
    double sagitta, reach;
};

Need need_of(const ThicknessRange& sheets, const std::vector<ObstacleSpec>& bodies) {
    Need need{sagitta * sheets.thinnest, 0.5 * sheets.thickest};
    for (const ObstacleSpec& body : bodies)
        if (const auto* ball = std::get_if<SphereShape>(&body.shape))
            need.reach = std::max(need.reach, ball->radius);
    return need;
}

/// The shape of an obstacle, with its surface and its deformation.
struct Made {
    std::shared_ptr<const Shape> shape;
    ColliderSurface surface;
    std::shared_ptr<const Deformation> deformation = nullptr;
};

template <class Solid>
Made make(const Solid& solid, const Need& need, std::vector<std::string>&) {
    return {std::make_shared<Solid>(solid), facets(solid, need.sagitta)};
}

double voxel_of(const ObstacleMesh& spec, const MeshMeasures& extent) {
    if (spec.voxel > 0) return spec.voxel;
    return std::max((extent.upper - extent.lower).norm() / voxels_along, SignedDistanceGrid::finest);
}

Made solid(const Mesh& mesh, double voxel, const Need& need) {
    return {std::make_shared<GridShape>(SignedDistanceGrid::of_mesh(mesh, voxel, need.reach)), facets(mesh)};
}

Made make(const ObstacleMesh& spec, const Need& need, std::vector<std::string>& warnings) {
    if (spec.cache) {
        DeformingMesh made = make_deforming_mesh(spec, warnings);
        return {std::make_shared<OpenSurface>(), std::move(made.surface),
                std::make_shared<Deformation>(std::move(made.deformation))};
    }
    const Mesh mesh = read_mesh(spec.file, warnings);
    const MeshMeasures extent = measure(mesh);
    const double voxel = voxel_of(spec, extent);
    if (extent.boundary_loops > 0)
        warnings.push_back(fmt::format("{} has {} holes; those of up to about a voxel, {:.3g} m, are closed",
                                       spec.file.path.string(), extent.boundary_loops, voxel));
    return with_context(spec.file.path.string(), [&] { return solid(mesh, voxel, need); });
}

Made make(const ObstacleLevelSet& spec, const Need& need, std::vector<std::string>&) {
    const auto shape = std::make_shared<GridShape>(
        SignedDistanceGrid::of_level_set(spec.path, spec.name, spec.scale, need.reach));
    return {shape, facets(shape->grid.surface())};
}

std::shared_ptr<const ColliderSurface> shared(ColliderSurface surface) {
    return surface.size() == 0 ? nullptr : std::make_shared<ColliderSurface>(std::move(surface));
}

/// Frame of a free body that is made from a mesh: its origin is the centre of mass, and its axes are the
/// principal ones.
struct MeshFrame {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();  ///< pose of the body's frame in the mesh's
                                                              ///< frame
    double volume = 0;                                        ///< m^3
    Vector3d inertia;                                         ///< m^5, principal moments for unit density
};

/// Returns the frame of the body of a mesh. Throws Error if the mesh is not the closed surface of a solid.
MeshFrame frame_of(const Mesh& mesh) {
    const MeshMeasures extent = measure(mesh);
    if (extent.boundary_loops > 0)
        throw Error(fmt::format("a free body needs a closed mesh, and this one has {} holes: close them",
                                extent.boundary_loops));
    const SolidMoments solid = solid_moments(mesh);
    if (!(solid.volume > least_filled * (extent.upper - extent.lower).prod()))
        throw Error(
            fmt::format("a free body needs a solid, and this mesh encloses {:.3g} m^3: {}", solid.volume,
                        solid.volume < 0 ? "its faces are turned inside out (repair = true turns them)"
                                         : "it is flat, or its parts have opposite orientations"));
    const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(solid.inertia());
    MeshFrame frame;
    frame.volume = solid.volume;
    frame.inertia = principal.eigenvalues();
    Matrix3d axes = principal.eigenvectors();
    if (axes.determinant() < 0) axes.col(2) *= -1;
    frame.place.linear() = axes;
    frame.place.translation() = solid.centre;
    return frame;
}

/// Makes a body from a mesh file, in the pose of the mesh in its file.
RigidBody make_body(const ObstacleMesh& spec, const FreeMotion& free, const Need& need) {
    std::vector<std::string> told;  // not printed: make_obstacles() returns the same warnings
    Mesh mesh = read_mesh(spec.file, told);
    return with_context(spec.file.path.string(), [&] {
        const MeshFrame frame = frame_of(mesh);
        const Eigen::Isometry3d to_body = frame.place.inverse();
        for (const Vertex v : mesh.vertices()) mesh.point(v) = point_at(to_body * position(mesh, v));
        const Made made = solid(mesh, voxel_of(spec, measure(mesh)), need);
        RigidBody body = rigid_solid(frame.volume, frame.inertia, made.surface.points,
                                     free.density > 0 ? free.density : free.mass / frame.volume);
        body.shape = made.shape;
        body.surface = shared(made.surface);
        body.centre = frame.place.translation();
        body.rotation = frame.place.linear();
        return body;
    });
}

RigidBody make_body(const SphereShape& sphere, const FreeMotion& free, const Need& need) {
    RigidBody body = rigid_sphere(sphere.radius, free.density);
    body.surface = shared(facets(SphereShape(Vector3d::Zero(), sphere.radius), need.sagitta));
    body.centre = sphere.centre;
    return body;
}

RigidBody make_body(const BoxShape& box, const FreeMotion& free, const Need&) {
    RigidBody body = rigid_box(2 * box.half, free.density);
    body.surface = shared(facets(BoxShape(Vector3d::Zero(), box.half), 0));
    body.centre = box.centre;
    return body;
}

/// Never called: complete_free_motion() of app/scene/read/obstacle.cpp reports free bodies of other kinds.
template <class Other>
RigidBody make_body(const Other&, const FreeMotion&, const Need&) {
    return {};
}

}  // namespace

std::vector<Obstacle> make_obstacles(const std::vector<ObstacleSpec>& specs, const ThicknessRange& sheets,
                                     std::vector<std::string>& warnings,
                                     const std::vector<ObstacleSpec>& bodies) {
    const Need need = need_of(sheets, bodies);
    std::vector<Obstacle> obstacles;
    for (const ObstacleSpec& spec : specs) {
        std::vector<std::string> found;
        Made made = with_context(spec.where, [&] {
            return std::visit([&](const auto& kind) { return make(kind, need, found); }, spec.shape);
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
    const Need need = need_of(sheets, scene.bodies);
    for (const ObstacleSpec& spec : scene.bodies) {
        RigidBody body = with_context(spec.where, [&] {
            return std::visit([&](const auto& kind) { return make_body(kind, *spec.free, need); },
                              spec.shape);
        });
        body.young = spec.young;
        body.friction = spec.friction;
        body.centre = spec.motion.place * body.centre;
        body.rotation = spec.motion.place.linear() * body.rotation;
        body.velocity = spec.free->velocity;
        body.angular_momentum = body.inertia_in_space() * spec.free->spin;
        bodies.push_back(body);
    }
    return bodies;
}

}  // namespace sherd
