// SPDX-License-Identifier: GPL-3.0-or-later
// An obstacle from a grid must push like the solid that it represents.
#include "meshops/level_set/signed_distance_grid.h"

#include <gtest/gtest.h>
#include <openvdb/tools/LevelSetSphere.h>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "tests/support/mesh/vdb_file.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

constexpr double radius = 0.1, voxel = 0.004;

Mesh sphere_mesh() {
    return generate_sphere(radius, {.edge_length = 0.01});
}

std::filesystem::path write_sphere(const TemporaryDirectory& directory, openvdb::GridClass kind) {
    openvdb::initialize();
    const auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(1, {3, 0, 0}, 0.04);
    grid->setName("ball");
    grid->setGridClass(kind);
    return write_vdb(directory.path / "ball.vdb", {grid});
}

/// Expects the distances and gradients of a sphere around `centre` within `tolerance` (m), outside its
/// innermost part.
void expect_sphere(const SignedDistanceGrid& grid, const Vector3d& centre, double tolerance) {
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const Vector3d out = random.matrix<Vector3d>(1).normalized();
        const double away = radius * random.uniform(0.3, 1.02);
        const auto sample = grid.sample(centre + away * out);
        ASSERT_NEAR(sample.distance, away - radius, tolerance);
        ASSERT_LT((sample.gradient - out).norm(), 0.15) << "at " << away;
    }
}

// Facets of 1 cm on a sphere of 10 cm lie up to 0.2 mm below it, which the tolerance allows.
TEST(SignedDistanceGrid, AMeshOfASphereIsASphere) {
    const SignedDistanceGrid grid = SignedDistanceGrid::of_mesh(sphere_mesh(), voxel, 0.002);
    expect_sphere(grid, Vector3d::Zero(), 4e-4);
    EXPECT_NEAR(grid.volume(), 4.0 / 3 * 3.14159265 * std::pow(radius, 3), 0.03 * std::pow(radius, 3));
    EXPECT_TRUE(std::isinf(grid.sample(Vector3d(0, 0, 2)).distance));
    EXPECT_LT(grid.sample(Vector3d::Zero()).distance, -0.09) << "filled to its centre";
    EXPECT_LT((grid.upper() - Vector3d::Constant(radius + voxel)).norm(), 2e-3);
}

// OpenVDB's own error names no remedy: the message must name voxels that are large enough.
TEST(SignedDistanceGrid, VoxelsThatOpenVdbDoesNotTakeAreNamed) {
    const Mesh small = generate_sphere(2e-4, {.edge_length = 5e-5});
    EXPECT_EQ(message_thrown_by([&] { SignedDistanceGrid::of_mesh(small, 1e-5, 1e-5); }),
              "its voxels of 1e-05 m are finer than OpenVDB allows: make them larger, 2e-05 m at least");
    EXPECT_NEAR(SignedDistanceGrid::of_mesh(small, SignedDistanceGrid::finest, 1e-5).volume(),
                4.0 / 3 * 3.14159265 * 8e-12, 2e-12);
}

// Contact force and stiffness are computed from these derivatives.
TEST(SignedDistanceGrid, DerivativesAreThoseOfTheInterpolatedDistance) {
    const SignedDistanceGrid grid = SignedDistanceGrid::of_mesh(sphere_mesh(), voxel, 0.002);
    Random random(2);
    const auto value = [&](const Vector3d& x) { return grid.sample(x).distance; };
    const auto gradient = [&](const Vector3d& x) { return grid.sample(x).gradient; };
    for (int i = 0; i < 300; ++i) {
        const Vector3d at = radius * random.uniform(0.1, 1.02) * random.matrix<Vector3d>(1).normalized();
        // The spline is one polynomial between neighbouring planes half-way between voxel centres. Its
        // second derivative jumps at these planes: points near them are skipped.
        const Vector3d place = at / voxel + Vector3d::Constant(0.5);
        const Vector3d within = place.array() - place.array().floor();
        if (within.minCoeff() < 0.01 || within.maxCoeff() > 0.99) continue;
        const auto sample = grid.sample(at);
        EXPECT_LT((sample.gradient - difference_gradient(value, at, 1e-5)).norm(), 1e-7);
        EXPECT_LT((sample.hessian - difference_hessian(gradient, at, 1e-5)).norm(),
                  1e-5 * (1 + sample.hessian.norm()));
    }
}

TEST(SignedDistanceGrid, ALevelSetIsTakenAsItIsScaledAndFilled) {
    const TemporaryDirectory directory;
    const auto file = write_sphere(directory, openvdb::GRID_LEVEL_SET);
    const SignedDistanceGrid grid = SignedDistanceGrid::of_level_set(file, "", radius, 0.002);
    EXPECT_NEAR(grid.voxel(), voxel, 1e-9);
    expect_sphere(grid, Vector3d(3 * radius, 0, 0), 3e-4);
    EXPECT_LT(grid.sample(Vector3d(3 * radius, 0, 0)).distance, -0.09) << "beyond the band of the file";
    for (const auto& [a, b, c] : grid.surface().triangles) {
        const auto& p = grid.surface().points;
        const Vector3d normal = (p[b] - p[a]).cross(p[c] - p[a]);
        ASSERT_GE(normal.dot(p[a] - Vector3d(3 * radius, 0, 0)), 0) << "inside out";
    }
}

// The values in files of Houdini or Blender must be used unchanged, in a rotated and moved grid, even if
// they are no true distances.
TEST(SignedDistanceGrid, VoxelsOfALevelSetAreTakenAsTheyAre) {
    const TemporaryDirectory directory;
    openvdb::initialize();
    const auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(1, {0, 0, 0}, 0.04);
    for (auto value = grid->beginValueOn(); value; ++value) value.setValue(0.9f * *value);
    grid->transform().postRotate(0.3, openvdb::math::Y_AXIS);
    grid->transform().postTranslate({3, 0.013, 0});
    const auto file = write_vdb(directory.path / "ball.vdb", {grid});
    const SignedDistanceGrid taken = SignedDistanceGrid::of_level_set(file, "", radius, 0.03);
    const Vector3d centre = radius * Vector3d(3, 0.013, 0);
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const Vector3d out = random.matrix<Vector3d>(1).normalized();
        const double away = radius * random.uniform(0.95, 1.05);
        const auto sample = taken.sample(centre + away * out);
        ASSERT_NEAR(sample.distance, 0.9 * (away - radius), 1e-4) << "the surface is 0.1 m";
        ASSERT_NEAR(sample.gradient.dot(out), 0.9, 0.03);
        ASSERT_LT((sample.gradient - 0.9 * out).norm(), 0.03);
    }
    EXPECT_NEAR(taken.sample(centre + Vector3d(0, 0, radius + 0.025)).distance, 0.025, 4e-4) << "added";
    EXPECT_LT(taken.sample(centre).distance, -0.09) << "filled";
}

TEST(SignedDistanceGrid, WhatIsNoSolidIsRefused) {
    const TemporaryDirectory directory;
    const auto file = write_sphere(directory, openvdb::GRID_FOG_VOLUME);
    const std::string fog =
        message_thrown_by([&] { SignedDistanceGrid::of_level_set(file, "ball", 1, 0.002); });
    EXPECT_NE(fog.find("ball.vdb: its grid 'ball' is of class 'fog volume'"), std::string::npos) << fog;
    EXPECT_NE(fog.find("needs a level set"), std::string::npos) << fog;
    const std::string fine =
        message_thrown_by([&] { SignedDistanceGrid::of_mesh(sphere_mesh(), 1e-5, 0.002); });
    EXPECT_NE(fine.find("make them larger"), std::string::npos) << fine;
    const Mesh tube = generate_cylinder(0.05, 0.1, {.edge_length = 0.01});
    const std::string open = message_thrown_by([&] { SignedDistanceGrid::of_mesh(tube, voxel, 0.002); });
    EXPECT_NE(open.find("it is open"), std::string::npos) << open;
}

// OpenVDB's exceptions would end a run without the name of the file; and NaN would keep a run computing for
// ever.
TEST(SignedDistanceGrid, ADamagedTransformIsRefused) {
    const TemporaryDirectory directory;
    const auto file = write_sphere(directory, openvdb::GRID_LEVEL_SET);
    const std::string whole = directory.contents().at(file.string());
    const std::string map = "UniformScaleTranslateMap";
    const std::size_t at = whole.find(map) + map.size(), size = 24;  // `at`: first of the map's vectors
    ASSERT_LT(at, whole.size());
    for (const char byte : {'\0', '\xff'}) {
        std::string damaged = whole;
        for (std::size_t vector = 0; vector < 6; ++vector)
            damaged.replace(at + vector * size, size, size, byte);
        directory.write("ball.vdb", damaged);
        const std::string message =
            message_thrown_by([&] { SignedDistanceGrid::of_level_set(file, "", 1, 0.002); });
        EXPECT_NE(message.find("ball.vdb: "), std::string::npos) << message;
    }
}

// Voxels that a damaged transform has made long and thin once kept the program busy for half a minute and
// more, with cubes of their smallest side.
TEST(SignedDistanceGrid, VeryOblongVoxelsAreRefused) {
    const TemporaryDirectory directory;
    openvdb::initialize();
    for (const double times : {16.0, 64.0}) {
        const auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(1, {3, 0, 0}, 0.1);
        grid->setName("ball");
        grid->transform().preScale({1, times, 1});
        const auto file = write_vdb(directory.path / "ball.vdb", {grid});
        const auto read = [&] { SignedDistanceGrid::of_level_set(file, "", 1, 0.002); };
        if (times < 20) {
            EXPECT_NO_THROW(read());
            continue;
        }
        const std::string message = message_thrown_by(read);
        EXPECT_NE(message.find("ball.vdb: its voxels are 6.4 m long and 0.1 m wide"), std::string::npos)
            << message;
    }
}

// A mesh with a hole of about a voxel still has an inside.
TEST(SignedDistanceGrid, SmallHolesAreClosed) {
    Mesh mesh = sphere_mesh();
    mesh.remove_face(Face(5));
    mesh.collect_garbage();
    const SignedDistanceGrid grid = SignedDistanceGrid::of_mesh(mesh, 0.01, 0.002);
    EXPECT_LT(grid.sample(Vector3d::Zero()).distance, -0.08);
}

}  // namespace
}  // namespace sherd::test
