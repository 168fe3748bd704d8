// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/level_set/signed_distance_grid.h"

#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>
#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "meshops/error.h"
#include "meshops/level_set/vdb_file.h"
#include "meshops/mesh_measures.h"
#include "meshops/solid/solid_moments.h"

namespace sherd {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double most_voxels = 1e8;  // 0.4 GB in single precision
// Largest accepted ratio of the sides of a voxel in a level set; with a larger one the file is damaged or its
// transform wrong.
constexpr double most_oblong = 20;
constexpr double layer_beyond = 3;  // voxels: distances that the spline uses beyond `reach`

/// A surface of triangles and quadrilaterals in OpenVDB's types; points in m.
struct Polygons {
    std::vector<openvdb::Vec3s> points;
    std::vector<openvdb::Vec3I> triangles;
    std::vector<openvdb::Vec4I> quads;
};

/// Weights in the spline of the three voxels in a row that are nearest to the index `at`, with the first and
/// second derivatives of the weights. `first` is the index of the first of these voxels.
struct SplineWeights {
    int first;
    std::array<double, 3> value, slope, bend{1, -2, 1};

    explicit SplineWeights(double at) : first(static_cast<int>(std::lround(at)) - 1) {
        const double f = at - (first + 1);
        value = {0.5 * (0.5 - f) * (0.5 - f), 0.75 - f * f, 0.5 * (0.5 + f) * (0.5 + f)};
        slope = {f - 0.5, -2 * f, f + 0.5};
    }
};

/// Concatenates the parts to a text; numbers get three significant digits.
template <class... Parts>
std::string text(const Parts&... parts) {
    std::ostringstream out;
    out.precision(3);
    (out << ... << parts);
    return out.str();
}

Vector3d eigen(const openvdb::Vec3s& p) {
    return {p.x(), p.y(), p.z()};
}

void require_coarse(double voxel) {
    if (voxel < SignedDistanceGrid::finest)
        throw Error(text("its voxels of ", voxel, " m are finer than OpenVDB allows: make them larger, ",
                         SignedDistanceGrid::finest, " m at least"));
}

void require_few_voxels(const Polygons& polygons, double voxel, double reach) {
    Eigen::AlignedBox3d box;
    for (const openvdb::Vec3s& p : polygons.points) box.extend(eigen(p));
    const double voxels = ((box.diagonal().array() + 2 * reach) / voxel + 2 * layer_beyond).prod();
    if (!(voxels <= most_voxels))  // also NaN, as in damaged files
        throw Error(text("would take ", voxels, " voxels of ", voxel, " m, more than ", most_voxels,
                         ": make them larger"));
}

/// Returns the smallest side of a voxel with the sides `size`, m. Throws Error if the voxel is so oblong that
/// too many cubes of its smallest side would be needed.
double smallest_side(const openvdb::Vec3d& size) {
    const auto [smallest, largest] = std::minmax({size.x(), size.y(), size.z()});
    if (largest > most_oblong * smallest)
        throw Error(text("its voxels are ", largest, " m long and ", smallest, " m wide, more than ",
                         most_oblong,
                         " times as long: correct its transform, or resample it to cubic voxels"));
    return smallest;
}

using TransformPointer = openvdb::math::Transform::Ptr;

openvdb::FloatGrid::Ptr distances(const Polygons& polygons, const TransformPointer& transform, double reach) {
    const double voxel = transform->voxelSize().x();
    // With several threads, chance would decide which of two triangles equally near to a voxel is kept.
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const auto layer = static_cast<float>(std::ceil(reach / voxel) + layer_beyond);
    return openvdb::tools::meshToSignedDistanceField<openvdb::FloatGrid>(
        *transform, polygons.points, polygons.triangles, polygons.quads, layer,
        std::numeric_limits<float>::max());
}

/// Copies the distances at active voxels of a level set, times `scale`, to the grid, except values as large
/// as the background of the level set.
void take_values(const openvdb::FloatGrid& level_set, double scale, openvdb::FloatGrid& grid) {
    auto voxels = grid.getAccessor();
    for (auto value = level_set.cbeginValueOn(); value; ++value)
        if (value.isVoxelValue() && std::abs(*value) < level_set.background())
            voxels.setValue(value.getCoord(), static_cast<float>(scale * *value));
}

Vector3d eigen(const openvdb::Vec3d& p) {
    return {p.x(), p.y(), p.z()};
}

/// Returns the map from positions (m) to voxel indices.
Eigen::Affine3d to_index(const openvdb::math::Transform& transform) {
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    map.translation() = eigen(transform.worldToIndex({0, 0, 0}));
    map.linear().col(0) = eigen(transform.worldToIndex({1, 0, 0})) - map.translation();
    map.linear().col(1) = eigen(transform.worldToIndex({0, 1, 0})) - map.translation();
    map.linear().col(2) = eigen(transform.worldToIndex({0, 0, 1})) - map.translation();
    return map;
}

Polygons polygons_of(const Mesh& mesh) {
    Polygons polygons;
    for (const Vertex v : mesh.vertices()) {
        const Vector3d p = position(mesh, v);
        polygons.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const Face face : mesh.faces()) {
        const Halfedge h = mesh.halfedge(face);
        polygons.triangles.emplace_back(mesh.source(h).idx(), mesh.target(h).idx(),
                                        mesh.target(mesh.next(h)).idx());
    }
    return polygons;
}

Polygons polygons_of(const openvdb::FloatGrid& level_set, double scale) {
    Polygons polygons;
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    openvdb::tools::volumeToMesh(level_set, polygons.points, polygons.quads);
    for (openvdb::Vec3s& p : polygons.points) p *= static_cast<float>(scale);
    return polygons;
}

double inner_volume(const openvdb::FloatGrid& grid) {
    std::size_t inside = 0;
    for (auto voxel = grid.cbeginValueOn(); voxel; ++voxel) inside += *voxel < 0 ? voxel.getVoxelCount() : 0;
    return static_cast<double>(inside) * std::pow(grid.voxelSize().x(), 3);
}

GridSurface surface_of(const Polygons& polygons) {
    GridSurface surface;
    for (const openvdb::Vec3s& p : polygons.points) surface.points.push_back(eigen(p));
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        surface.triangles.push_back(
            {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)});
    };
    for (const openvdb::Vec3I& t : polygons.triangles) add(t[0], t[1], t[2]);
    for (const openvdb::Vec4I& q : polygons.quads) {  // quadrilaterals of OpenVDB are clockwise
        add(q[0], q[2], q[1]);
        add(q[0], q[3], q[2]);
    }
    return surface;
}

}  // namespace

struct SignedDistanceGrid::State {
    openvdb::FloatGrid::Ptr grid;
    double voxel;
    Eigen::Affine3d to_index;
    GridSurface surface;
    Eigen::AlignedBox3d box;

    State(const Polygons& polygons, const TransformPointer& transform, double reach)
        : grid(distances(polygons, transform, reach)),
          voxel(transform->voxelSize().x()),
          to_index(sherd::to_index(*transform)),
          surface(surface_of(polygons)) {
        // The points of the surface, in single precision, deviate slightly from where the distances are zero.
        // Without a margin of a voxel, the box could end within the solid, and forces would jump at its
        // sides.
        const Vector3d margin = Vector3d::Constant(voxel);
        for (const Vector3d& p : surface.points) box.extend(p - margin).extend(p + margin);
    }

    /// Makes the state of a level set that was read from a file, in its world space times `scale` and with a
    /// layer up to `reach` (m). Throws Error, or exceptions of OpenVDB.
    static std::shared_ptr<const State> of(const openvdb::FloatGrid& level_set, double scale, double reach);
};

std::shared_ptr<const SignedDistanceGrid::State> SignedDistanceGrid::State::of(
    const openvdb::FloatGrid& level_set, double scale, double reach) {
    if (level_set.getGridClass() != openvdb::GRID_LEVEL_SET)
        throw Error(text("its grid '", level_set.getName(), "' is of class '",
                         openvdb::GridBase::gridClassToString(level_set.getGridClass()), "', background ",
                         level_set.background(),
                         "; an obstacle needs a level set (signed distances near the surface), such as a "
                         "distance VDB of Houdini's VDB from Polygons"));
    const Polygons polygons = polygons_of(level_set, scale);
    if (polygons.points.empty()) throw Error("its level set is empty");
    const openvdb::Vec3d unscaled = level_set.transform().voxelSize();
    require_coarse(scale * std::min({unscaled.x(), unscaled.y(), unscaled.z()}));
    TransformPointer transform = level_set.transform().copy();
    transform->postScale(scale);
    const openvdb::Vec3d size = transform->voxelSize();
    const double smallest = smallest_side(size);
    require_few_voxels(polygons, smallest, reach);
    const bool cubic = transform->isLinear() && transform->hasUniformScale();
    if (!cubic) transform = openvdb::math::Transform::createLinearTransform(smallest);
    auto state = std::make_shared<State>(polygons, transform, reach);
    if (cubic) take_values(level_set, scale, *state->grid);
    return state;
}

SignedDistanceGrid::SignedDistanceGrid(std::shared_ptr<const State> state) : state(std::move(state)) {}

SignedDistanceGrid SignedDistanceGrid::of_mesh(const Mesh& mesh, double voxel, double reach) {
    openvdb::initialize();
    require_coarse(voxel);
    const Polygons polygons = polygons_of(mesh);
    require_few_voxels(polygons, voxel, reach);
    SignedDistanceGrid grid(
        std::make_shared<State>(polygons, openvdb::math::Transform::createLinearTransform(voxel), reach));
    const double expected = std::abs(solid_moments(mesh).volume), found = grid.volume();
    if (found > 0.5 * expected && found > 0) return grid;
    throw Error(
        text("encloses no solid at a voxel of ", voxel, " m (", found, " of ", expected, " m^3): ",
             measure(mesh).boundary_loops > 0
                 ? "it is open, and a hole wider than a voxel lets the outside in; close it, or make the "
                   "voxels larger"
                 : "it is thinner than a voxel; make the voxels smaller"));
}

SignedDistanceGrid SignedDistanceGrid::of_level_set(const std::filesystem::path& file,
                                                    const std::string& name, double scale, double reach) {
    const openvdb::FloatGrid::Ptr level_set = read_float_grid(file, name);
    return with_context(file.string(), [&] {
        try {
            return SignedDistanceGrid(State::of(*level_set, scale, reach));
        } catch (const openvdb::Exception& error) {
            throw Error(std::string("damaged OpenVDB file: ") + error.what());
        }
    });
}

SignedDistanceGrid::Sample SignedDistanceGrid::sample(const Vector3d& point) const {
    const Vector3d index = state->to_index * point;
    const SplineWeights x(index.x()), y(index.y()), z(index.z());
    const auto voxels = state->grid->getConstUnsafeAccessor();
    const float beyond = state->grid->background();
    Sample sum{0, Vector3d::Zero(), Matrix3d::Zero()};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) {
                const float value = voxels.getValue({x.first + i, y.first + j, z.first + k});
                if (value >= beyond)
                    return {std::numeric_limits<double>::infinity(), Vector3d::Zero(), Matrix3d::Zero()};
                sum.distance += value * x.value[i] * y.value[j] * z.value[k];
                sum.gradient += value * Vector3d(x.slope[i] * y.value[j] * z.value[k],
                                                 x.value[i] * y.slope[j] * z.value[k],
                                                 x.value[i] * y.value[j] * z.slope[k]);
                sum.hessian.diagonal() +=
                    value * Vector3d(x.bend[i] * y.value[j] * z.value[k], x.value[i] * y.bend[j] * z.value[k],
                                     x.value[i] * y.value[j] * z.bend[k]);
                sum.hessian(1, 0) += value * x.slope[i] * y.slope[j] * z.value[k];
                sum.hessian(2, 0) += value * x.slope[i] * y.value[j] * z.slope[k];
                sum.hessian(2, 1) += value * x.value[i] * y.slope[j] * z.slope[k];
            }
    const Matrix3d by_place = state->to_index.linear();
    sum.gradient = (by_place.transpose() * sum.gradient).eval();
    sum.hessian =
        by_place.transpose() * sum.hessian.selfadjointView<Eigen::Lower>().toDenseMatrix() * by_place;
    return sum;
}

Vector3d SignedDistanceGrid::lower() const {
    return state->box.min();
}

Vector3d SignedDistanceGrid::upper() const {
    return state->box.max();
}

double SignedDistanceGrid::voxel() const {
    return state->voxel;
}

double SignedDistanceGrid::volume() const {
    return inner_volume(*state->grid);
}

const GridSurface& SignedDistanceGrid::surface() const {
    return state->surface;
}

}  // namespace sherd
