// SPDX-License-Identifier: GPL-3.0-or-later
// A closed mesh with a density must become the body of its solid, and no other mesh may.
#include <gtest/gtest.h>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/obstacle/obstacles.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/plate_and_obstacle.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

ProgramResult check_of_mesh(const std::string& mesh, const std::string& obstacle) {
    const TemporaryDirectory directory;
    directory.write("solid.obj", mesh);
    directory.write("scene.toml", plate_and_obstacle + obstacle);
    return run_sherd({"check", "scene.toml"}, directory.path);
}

/// Text of an OBJ file of a box of 1 m by 2 m by 3 m about (5, 0, 0). faces: how many of its twelve triangles
/// it has.
std::string box_mesh(int faces = 12) {
    std::string text;
    for (int i = 0; i < 8; ++i)
        text += "v " + std::to_string(5 + (i & 1 ? 0.5 : -0.5)) + " " + std::to_string(i & 2 ? 1 : -1) + " " +
                std::to_string(i & 4 ? 1.5 : -1.5) + "\n";
    const std::vector<std::string> triangles{"1 3 4", "1 4 2", "5 6 8", "5 8 7", "1 2 6", "1 6 5",
                                             "3 7 8", "3 8 4", "1 5 7", "1 7 3", "2 4 8", "2 8 6"};
    for (int i = 0; i < faces; ++i) text += "f " + triangles[i] + "\n";
    return text;
}

// A closed mesh must become the body of its solid: a box of twelve triangles must have the mass and inertia
// of `box`. (Its surface touches sheets, its vertices touch all else.)
TEST(FreeMesh, AClosedMeshBecomesAFreeBody) {
    const std::string placed =
        "place = { translate = [0, 0, 3], rotate = { axis = [1, 2, 0], degrees = 40 } }\nvelocity = [1, 0, "
        "0]\nspin = [0, 0, 9]\n";
    const TemporaryDirectory directory;
    directory.write("solid.obj", box_mesh());
    const Scene scene = read_scene(directory.write(
        "scene.toml",
        plate_and_obstacle + "mesh = \"solid.obj\"\ndensity = 10\n" + placed +
            "[obstacle.other]\nmesh = { file = \"solid.obj\", scale = 0.5 }\nmass = 60\n" + placed +
            "[obstacle.box]\nbox = { size = [1, 2, 3], centre = [5, 0, 0] }\nmass = 60\n" + placed));
    const std::vector<RigidBody> bodies = make_bodies(scene, ThicknessRange{0.004, 0.004});
    ASSERT_EQ(bodies.size(), 3u);
    const RigidBody &solid = bodies[0], &half = bodies[1], &box = bodies[2];
    EXPECT_NEAR(solid.mass, 60, 1e-9);
    EXPECT_NEAR(half.mass, 60, 1e-9);
    // `rotate` turns a box about its centre, and a mesh about its origin.
    EXPECT_LT((solid.centre - scene.bodies[0].motion.place * Vector3d(5, 0, 0)).norm(), 1e-9);
    EXPECT_LT((solid.inertia_in_space() - box.inertia_in_space()).norm(), 1e-6);
    EXPECT_LT((half.inertia_in_space() - 0.25 * box.inertia_in_space()).norm(), 1e-6);
    EXPECT_LT((solid.spin() - Vector3d(0, 0, 9)).norm(), 1e-9);
    EXPECT_NEAR(solid.rotation.determinant(), 1, 1e-12);
    EXPECT_EQ(solid.contact_points.size(), 8u);
    ASSERT_TRUE(solid.surface);
    for (const auto& point : solid.surface->points.colwise()) {
        const Vector3d here = box.rotation.transpose() * solid.rotation * Vector3d(point);
        EXPECT_LT((here.cwiseAbs() - Vector3d(0.5, 1, 1.5)).norm(), 1e-9) << "the box, in its own frame";
        EXPECT_NEAR(solid.shape->distance(0.8 * Vector3d(point)).distance, -0.1, 0.03);
    }
}

// An open mesh has no defined mass: if it were accepted, the body's mass would depend on its holes, without a
// message.
TEST(FreeMesh, AFreeBodyOfAMeshThatIsNoSolidIsRefused) {
    const ProgramResult open = check_of_mesh(box_mesh(11), "mesh = \"solid.obj\"\ndensity = 10");
    EXPECT_EQ(open.exit_code, 2) << open.out;
    EXPECT_NE(open.err.find("scene.toml:7: obstacle.thing.mesh: "), std::string::npos) << open.err;
    EXPECT_NE(open.err.find("a free body needs a closed mesh, and this one has 1 holes"), std::string::npos)
        << open.err;
    const ProgramResult flat =
        check_of_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\nf 1 3 2\nf 2 3 4\n",
                      "mesh = { file = \"solid.obj\", repair = false }\ndensity = 10");
    EXPECT_EQ(flat.exit_code, 2) << flat.out;
    std::string turned = box_mesh(0);
    for (const char* face : {"1 4 3", "1 2 4", "5 8 6", "5 7 8", "1 6 2", "1 5 6", "3 8 7", "3 4 8", "1 7 5",
                             "1 3 7", "2 8 4", "2 6 8"})
        turned += std::string("f ") + face + "\n";
    const ProgramResult inside_out =
        check_of_mesh(turned, "mesh = { file = \"solid.obj\", repair = false }\ndensity = 10");
    EXPECT_EQ(inside_out.exit_code, 2) << inside_out.out;
    EXPECT_NE(inside_out.err.find("points into the closed surface"), std::string::npos) << inside_out.err;
    EXPECT_EQ(check_of_mesh(turned, "mesh = \"solid.obj\"\ndensity = 10").exit_code, 0) << "it is repaired";
    const ProgramResult whole = check_of_mesh(box_mesh(), "mesh = \"solid.obj\"\ndensity = 10");
    EXPECT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_NE(whole.out.find("free obstacle thing\n  mass 60 kg, centre of mass (5, 0, 0) m"),
              std::string::npos)
        << whole.out;
}

// The distance field of a mesh must extend as far as the radius of the largest ball: otherwise this ball
// would sink in up to its centre.
TEST(FreeMesh, AMeshIsFeltByABallAsFarOffAsItIsLarge) {
    const TemporaryDirectory directory;
    directory.write("solid.obj", box_mesh());
    const Scene scene = read_scene(directory.write(
        "scene.toml", plate_and_obstacle + "mesh = \"solid.obj\"\n[obstacle.ball]\nsphere = { radius "
                                           "= 0.4, centre = [5, 0, 1.9] }\ndensity = 10\n"));
    std::vector<std::string> warnings;
    const Obstacle solid =
        make_obstacles(scene.obstacles, ThicknessRange{0.004, 0.004}, warnings, scene.bodies).at(0);
    EXPECT_NEAR(solid.shape->distance(Vector3d(5, 0, 1.88)).distance, 0.38, 0.01);
}

}  // namespace
}  // namespace sherd::test
