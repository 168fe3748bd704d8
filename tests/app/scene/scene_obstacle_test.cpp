// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles must be as the scene describes them, and faults must be reported with their line, before the run.
#include <gtest/gtest.h>

#include <numbers>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/obstacle/obstacles.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "tests/support/program/plate_and_obstacle.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using std::numbers::pi;

Scene scene_around(const std::string& obstacle) {
    const TemporaryDirectory directory;
    return read_scene(directory.write("scene.toml", plate_and_obstacle + obstacle));
}

ThicknessRange thickness_of(const Scene& scene) {
    const double thickness = scene.sheets.front().material.thickness;
    return {thickness, thickness};
}

Obstacle obstacle_of(const std::string& obstacle) {
    const Scene scene = scene_around(obstacle);
    std::vector<std::string> warnings;
    return make_obstacles(scene.obstacles, thickness_of(scene), warnings).at(0);
}

double distance(const Obstacle& obstacle, double time, const Vector3d& at) {
    return obstacle.shape->distance(obstacle.motion.at(time).inverse() * at).distance;
}

TEST(SceneObstacle, ShapesAreWhereTheyArePlaced) {
    const Obstacle sphere =
        obstacle_of("sphere = { radius = 0.5, centre = [0, 1, 0] }\nfriction = 0.2\nyoung = 1e9");
    EXPECT_NEAR(distance(sphere, 0, Vector3d(0, 2, 0)), 0.5, 1e-15);
    EXPECT_EQ(sphere.friction, 0.2);
    EXPECT_EQ(sphere.young, 1e9);
    const Obstacle box = obstacle_of(
        "box = { size = [2, 4, 6] }\nplace = { translate = [0, 0, 5], rotate = { axis = [1, 0, 0], degrees = "
        "90 } }");
    EXPECT_NEAR(distance(box, 0, Vector3d(1.5, 0, 5)), 0.5, 1e-15);
    EXPECT_NEAR(distance(box, 0, Vector3d(0, 0, 7.5)), 0.5, 1e-12) << "its y is up";
    EXPECT_NEAR(distance(box, 0, Vector3d(0, 3.5, 5)), 0.5, 1e-12);
    const Obstacle cylinder =
        obstacle_of("cylinder = { radius = 1, length = 4, centre = [0, 0, 1], axis = [0, 9, 0] }");
    EXPECT_NEAR(distance(cylinder, 0, Vector3d(0, 0, 2.5)), 0.5, 1e-15);
    EXPECT_NEAR(distance(cylinder, 0, Vector3d(0, -2.5, 1)), 0.5, 1e-15);
    EXPECT_NEAR(distance(obstacle_of("plane = {}\nplace.translate = [0, 0, -1]"), 0, Vector3d(5, 6, 0)), 1,
                1e-15);
}

// The rotation must be about the placed centre of the obstacle, not about the origin of the scene.
TEST(SceneObstacle, KeysMoveItFromWhereItWasPlaced) {
    const Obstacle box = obstacle_of(R"(box = { size = [2, 2, 4], centre = [1, 0, 0] }
place.translate = [9, 0, 0]
keys = [{ time = 1 }, { time = 2, translate = [0, 0, 3], rotate = { axis = [1, 0, 0], degrees = 90 } }]
motion = "linear"
)");
    EXPECT_NEAR(distance(box, 0.5, Vector3d(10, 0, 2.5)), 0.5, 1e-12);
    EXPECT_NEAR(distance(box, 1.5, Vector3d(10, 0, 1.5)), -1, 1e-12) << "half-way up";
    EXPECT_NEAR(distance(box, 7, Vector3d(10, 0, 4.5)), 0.5, 1e-12);
    EXPECT_NEAR(distance(box, 7, Vector3d(10, 2.5, 3)), 0.5, 1e-12);
    EXPECT_FALSE(box.motion.smooth);
    EXPECT_TRUE(obstacle_of("plane = {}\nkeys = { time = 1 }").motion.smooth);
}

const std::string octahedron =
    "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\n"
    "f 3 1 6\nf 2 3 6\nf 4 2 6\n";

/// Runs `sherd check` on a scene of a plate and an obstacle. mesh: content of solid.obj; obstacle: the
/// obstacle's keys.
ProgramResult checked(const std::string& mesh, const std::string& obstacle) {
    const TemporaryDirectory directory;
    directory.write("solid.obj", mesh);
    directory.write("scene.toml", plate_and_obstacle + obstacle);
    return run_sherd({"check", "scene.toml"}, directory.path);
}

// Names of mesh files must be relative to the scene, whatever the working directory.
TEST(SceneObstacle, AMeshFileBecomesASolid) {
    const TemporaryDirectory directory;
    directory.write("solid.obj", octahedron + "f 1 4 6\n");
    const Scene scene = read_scene(directory.write(
        "scene.toml",
        plate_and_obstacle +
            "mesh = { file = \"solid.obj\", scale = 0.1, voxel = 0.002 }\nplace.translate = [1, 0, 0]"));
    std::vector<std::string> warnings;
    const Obstacle solid = make_obstacles(scene.obstacles, thickness_of(scene), warnings).at(0);
    EXPECT_TRUE(warnings.empty());
    EXPECT_NEAR(distance(solid, 0, Vector3d(1, 0, 0)), -0.1 / std::sqrt(3.0), 1e-3);
    EXPECT_NEAR(distance(solid, 0, Vector3d(1.034, 0.034, 0.034)), 0.002 / std::sqrt(3.0), 2e-4);
    EXPECT_EQ(solid.surface->triangles.size(), 8u);
}

// By default voxels are a hundredth of the mesh's diagonal: for a grain that is finer than OpenVDB permits.
TEST(SceneObstacle, AGrainOfHalfAMillimetreIsASolid) {
    const TemporaryDirectory directory;
    directory.write("solid.obj", octahedron + "f 1 4 6\n");
    const Scene scene = read_scene(directory.write(
        "scene.toml", plate_and_obstacle + "mesh = { file = \"solid.obj\", scale = 0.00025 }"));
    std::vector<std::string> warnings;
    const Obstacle solid = make_obstacles(scene.obstacles, thickness_of(scene), warnings).at(0);
    EXPECT_NEAR(distance(solid, 0, Vector3d::Zero()), -0.00025 / std::sqrt(3.0), 2e-5);
}

TEST(SceneObstacle, AMeshThatEnclosesNothingIsRefused) {
    const ProgramResult open = checked(octahedron, "mesh = \"solid.obj\"");
    EXPECT_EQ(open.exit_code, 2) << open.out;
    for (const char* part :
         {"scene.toml:7: obstacle.thing.mesh: ", "solid.obj: encloses no solid", "it is open"})
        EXPECT_NE(open.err.find(part), std::string::npos) << open.err;
    const ProgramResult missing = checked("", "mesh = \"nowhere.obj\"");
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_NE(missing.err.find("scene.toml:7: obstacle.thing.mesh: "), std::string::npos) << missing.err;
    const ProgramResult no_grid = checked(octahedron, "vdb = { file = \"solid.obj\" }");
    EXPECT_EQ(no_grid.exit_code, 2);
    EXPECT_NE(no_grid.err.find("solid.obj: damaged OpenVDB file, or not OpenVDB at all"), std::string::npos)
        << no_grid.err;
    const ProgramResult fine =
        checked(octahedron + "f 1 4 6\n", "mesh = { file = \"solid.obj\", voxel = 1e-5 }");
    EXPECT_EQ(fine.exit_code, 2);
    EXPECT_NE(fine.err.find("make them larger"), std::string::npos) << fine.err;
}

// Drawn surfaces must coincide with the surfaces of contact, be closed, and face outward.
TEST(SceneObstacle, DrawnSurfacesAreThoseOfTheSolids) {
    for (const std::string& text :
         {std::string("sphere = { radius = 0.5, centre = [1, 0, 0] }"),
          std::string("box = { size = [1, 2, 3], centre = [1, 0, 0] }"),
          std::string("cylinder = { radius = 0.5, length = 2, centre = [1, 0, 0], axis = [1, 1, 0] }")}) {
        const Scene scene = scene_around(text);
        std::vector<std::string> warnings;
        const Obstacle made = make_obstacles(scene.obstacles, thickness_of(scene), warnings).at(0);
        const Positions& points = made.surface->points;
        double volume = 0;
        for (const auto& p : points.colwise()) EXPECT_NEAR(made.shape->distance(p).distance, 0, 1e-14);
        for (const auto& [a, b, c] : made.surface->triangles)
            volume += points.col(a).dot(points.col(b).cross(points.col(c))) / 6;
        const double exact = text[0] == 's' ? pi / 6 : text[0] == 'b' ? 6 : pi / 2;
        EXPECT_NEAR(volume, exact, 0.01 * exact) << text;
    }
    EXPECT_EQ(obstacle_of("plane = {}").surface, nullptr);
}

TEST(SceneObstacle, DensityOrMassMakesAFreeBody) {
    const Scene scene = scene_around(R"(sphere = { radius = 0.1, centre = [1, 0, 0] }
place.translate = [0, 0, 3]
mass = 5
velocity = [1, 2, 3]
spin = [0, 0, 9]
friction = 0.2
[obstacle.brick]
box = { size = [1, 2, 3] }
density = 10
place.rotate = { axis = [0, 0, 1], degrees = 90 }
)");
    EXPECT_TRUE(scene.obstacles.empty());
    const std::vector<RigidBody> bodies = make_bodies(scene, thickness_of(scene));
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_NEAR(bodies[0].mass, 5, 1e-12);
    EXPECT_TRUE(bodies[0].centre.isApprox(Vector3d(1, 0, 3)));
    EXPECT_EQ(bodies[0].velocity, Vector3d(1, 2, 3));
    EXPECT_TRUE(bodies[0].spin().isApprox(Vector3d(0, 0, 9)));
    EXPECT_NEAR(bodies[0].inertia[1], 0.4 * 5 * 0.01, 1e-12);
    EXPECT_EQ(bodies[0].friction, 0.2);
    EXPECT_NEAR(bodies[1].mass, 60, 1e-12);
    EXPECT_NEAR(bodies[1].inertia_in_space()(0, 0), 60.0 / 12 * (1 + 9), 1e-9) << "turned";
}

void expect_error(const std::string& obstacle, const std::vector<std::string>& parts) {
    try {
        scene_around(obstacle);
        ADD_FAILURE() << "no error: " << obstacle;
    } catch (const Error& error) {
        for (const std::string& part : parts)
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
                << "no '" << part << "' in: " << error.what();
    }
}

TEST(SceneObstacle, WhatCannotBeIsToldWithItsLine) {
    expect_error("friction = 1", {"scene.toml:6: obstacle.thing: needs one of plane, sphere, box, cylinder"});
    expect_error("plane = {}\nsphere = { radius = 1 }",
                 {"scene.toml:8: obstacle.thing.sphere: conflicts with plane"});
    expect_error("sphere = 3", {"scene.toml:7: obstacle.thing.sphere: must be a table"});
    expect_error("sphere = { centre = [0, 0, 0] }", {"sphere.radius: is missing"});
    expect_error("sphere = { radius = -1 }",
                 {"scene.toml:7: obstacle.thing.sphere.radius: must be a positive number (m)"});
    expect_error("sphere = { radius = 1, center = [0, 0, 0] }",
                 {"sphere.center: unknown key; did you mean 'centre'?"});
    expect_error("sphere = { radius = 1, centre = [0, 0] }",
                 {"scene.toml:7: obstacle.thing.sphere.centre: must be an array of 3"});
    expect_error("box = {}", {"box.size: is missing"});
    expect_error("box = { size = [1, 0, 1] }",
                 {"scene.toml:7: obstacle.thing.box.size: must be three positive lengths"});
    expect_error("cylinder = { radius = 1 }", {"cylinder.length: is missing"});
    expect_error("cylinder = { radius = 1, length = 1, axis = [0, 0, 0] }",
                 {"cylinder.axis: must not be zero"});
    expect_error("mesh = { scale = 1 }", {"mesh.file: is missing"});
    expect_error("mesh = { file = \"a.obj\", voxel = 0 }", {"mesh.voxel: must be a positive number (m)"});
    expect_error("mesh = { file = \"a.obj\", remesh = 1 }", {"mesh.remesh: unknown key"});
    expect_error("vdb = { file = \"a.vdb\", name = \"b\" }",
                 {"scene.toml:7: obstacle.thing.vdb.name: unknown key"});
    expect_error("vdb = { file = \"a.vdb\", scale = 0 }", {"vdb.scale: must be a positive"});
    expect_error("sphere = { radius = 1 }\nvelocity = [1, 0, 0]", {"thing.velocity: needs density or mass"});
    expect_error("sphere = { radius = 1 }\nmass = 1\ndensity = 1", {"thing.density: conflicts with mass"});
    expect_error("plane = {}\nmass = 1", {"thing.mass: is for a sphere, a box or a mesh"});
    expect_error("box = { size = [1, 1, 1] }\nmass = 1\nkeys = { time = 1 }",
                 {"thing.mass: conflicts with keys"});
    expect_error("sphere = { radius = 1 }\ndensity = -1",
                 {"thing.density: must be a positive number (kg/m^3)"});
    expect_error("plane = {}\nplace = { move = [0, 0, 1] }",
                 {"scene.toml:8: obstacle.thing.place.move: unknown key"});
    expect_error("plane = {}\nplace.rotate = { axis = [0, 0, 0], degrees = 1 }",
                 {"place.rotate.axis: must not be zero"});
    expect_error("plane = {}\nkeys = [{ translate = [0, 0, 1] }]",
                 {"scene.toml:8: obstacle.thing.keys[0].time: is missing"});
    expect_error("plane = {}\nkeys = [{ time = 1 }, { time = 1 }]",
                 {"keys[1].time: must be later than that of the previous key (1 s)"});
    expect_error("plane = {}\nkeys = [{ time = 1, rotate = { axis = [0, 0, 1] } }]",
                 {"keys[0].rotate.degrees: is missing"});
    expect_error("plane = {}\nkeys = [{ time = 1, rotate = { axis = [0, 0, 0], degrees = 3 } }]",
                 {"keys[0].rotate.axis: must not be zero"});
    expect_error("plane = {}\nkeys = [{ time = 1, turn = 3 }]", {"keys[0].turn: unknown key"});
    expect_error("plane = {}\nmotion = \"smooth\"", {"scene.toml:8: obstacle.thing.motion: needs keys"});
    expect_error("plane = {}\nkeys = { time = 1 }\nmotion = \"smoth\"",
                 {"scene.toml:9: obstacle.thing.motion", "did you mean \"smooth\"?"});
}

// A sheet that starts inside would be thrown out; the message must name the sheet, the depth and the
// obstacle.
TEST(SceneObstacle, ASheetThatStartsInsideIsNamed) {
    const TemporaryDirectory directory;
    const auto outcome = [&](const std::string& command, double height) {
        directory.write("scene.toml",
                        plate_and_obstacle + "plane = { point = [0, 0, " + std::to_string(height) + "] }\n");
        return run_sherd({command, "scene.toml", "--set", "contact.start='error'"}, directory.path);
    };
    for (const std::string command : {"check", "run"}) {
        const ProgramResult deep = outcome(command, 0.9995);
        EXPECT_EQ(deep.exit_code, 2) << deep.err;
        EXPECT_NE(deep.err.find("scene.toml:7: obstacle.thing.plane: "), std::string::npos) << deep.err;
        EXPECT_NE(deep.err.find(" vertices of sheet.plate start inside; the deepest, vertex "),
                  std::string::npos)
            << deep.err;
        EXPECT_NE(deep.err.find("is 0.0015 m beyond touching"), std::string::npos)
            << "4 mm thick: touching at 2 mm; " << deep.err;
    }
    EXPECT_FALSE(std::filesystem::exists(directory.path / "scene.h5"));
    const ProgramResult shallow = outcome("check", 0.9981);
    EXPECT_EQ(shallow.exit_code, 0) << shallow.err;
    EXPECT_NE(shallow.out.find("is 0.0001 m beyond touching"), std::string::npos) << shallow.out;
    EXPECT_EQ(outcome("check", 0.998).out.find("start inside"), std::string::npos) << "it lies on the plane";
}

// Without contact.start = "error" the sheet must run, and neither be thrown out nor fall through.
TEST(SceneObstacle, ASheetThatStartsInsideStaysThere) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", plate_and_obstacle + "plane = { point = [0, 0, 0.9995] }\n");
    const ProgramResult run = run_sherd({"run", "scene.toml", "-o", "run.h5"}, directory.path);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.err.find("is 0.0015 m beyond touching"), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("contact acts only where it gets deeper"), std::string::npos) << run.err;
}

// The corner of a box is between the vertices of a face: no vertex is inside, but contact would be wrong.
TEST(SceneObstacle, AFaceThatStartsAcrossASurfaceIsNamed) {
    const TemporaryDirectory directory;
    const auto outcome = [&](const std::string& command, const std::string& box) {
        directory.write("scene.toml", plate_and_obstacle + "box = " + box + "\n");
        return run_sherd({command, "scene.toml", "--set", "contact.start='error'"}, directory.path);
    };
    for (const std::string command : {"check", "run"}) {
        const ProgramResult across =
            outcome(command, "{ size = [1e-3, 1e-3, 0.1], centre = [0.012, 0.01, 0.97] }");
        EXPECT_EQ(across.exit_code, 2) << across.err;
        for (const char* part : {"scene.toml:7: obstacle.thing.box: ",
                                 " faces of sheet.plate start across its "
                                 "surface; the first is face "})
            EXPECT_NE(across.err.find(part), std::string::npos) << across.err;
        const ProgramResult near =
            outcome(command, "{ size = [1e-3, 1e-3, 0.1], centre = [0.012, 0.01, 0.9492] }");
        EXPECT_EQ(near.exit_code, 2) << near.err;
        EXPECT_NE(near.err.find("sheet.plate starts 0.0008 m from its surface, at ("), std::string::npos)
            << near.err;
    }
    EXPECT_EQ(
        outcome("check", "{ size = [1e-3, 1e-3, 0.1], centre = [0.012, 0.01, 0.948] }").out.find("starts"),
        std::string::npos);
}

// The check tests all sheets together, but numbers in its messages must count within the sheet that it names.
TEST(SceneObstacle, OfSeveralSheetsTheOneThatIsInTheWayIsNamed) {
    const TemporaryDirectory directory;
    directory.write("square.obj", "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n");
    const auto scene_with = [&](const std::string& box) {
        std::string text = "duration = 0.002\ncontact.start = \"error\"\n";
        for (const char* x : {"0", "1", "2"})
            text += "[sheet.at" + std::string(x) + "]\nmesh = \"square.obj\"\nplace.translate = [" + x +
                    ", 0, 1]\nmaterial = { preset = \"stoneware\" }\n";
        return directory.write("scene.toml", text + "[obstacle.thing]\nbox = " + box + "\n");
    };
    const auto message_of = [&](const std::string& box) {
        std::vector<std::string> warnings;
        try {
            build_scene(read_scene(scene_with(box)), warnings);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    // The box goes through the triangle beyond the diagonal, whose centre is at a third and two thirds of the
    // square.
    const std::string across = message_of("{ size = [1e-3, 1e-3, 0.1], centre = [1.03, 0.07, 0.97] }");
    EXPECT_NE(across.find("1 of 2 faces of sheet.at1 start across its surface; the first is face 1 at "
                          "(1.033, 0.06667, 1) m"),
              std::string::npos)
        << across;
    EXPECT_EQ(across.find("at0"), std::string::npos) << across;
    EXPECT_EQ(across.find("at2"), std::string::npos) << across;
    const std::string near = message_of("{ size = [1e-3, 1e-3, 0.1], centre = [2.03, 0.07, 0.9492] }");
    EXPECT_NE(near.find("sheet.at2 starts 0.0008 m from its surface"), std::string::npos) << near;
    EXPECT_EQ(near.find("at1"), std::string::npos) << near;
}

// Contact springs of 1e9 N/m would throw the body out at a hundred metres per second.
TEST(SceneObstacle, ABodyThatStartsInAnotherOneIsNamed) {
    const TemporaryDirectory directory;
    const auto outcome = [&](double height) {
        directory.write("scene.toml",
                        plate_and_obstacle +
                            "plane = {}\n[obstacle.ball]\nsphere = { radius = 0.1, centre = [0, 0, " +
                            std::to_string(height) +
                            "] }\ndensity = 1000\n[obstacle.brick]\n"
                            "box = { size = [0.1, 0.1, 0.1], centre = [0.14, 0, 0.1] }\nmass = 1\n");
        return run_sherd({"check", "scene.toml"}, directory.path);
    };
    const ProgramResult inside = outcome(0.09);
    EXPECT_EQ(inside.exit_code, 2) << inside.err;
    for (const char* part : {"scene.toml:9: obstacle.ball.sphere: starts 0.01 m inside obstacle.thing",
                             "scene.toml:12: obstacle.brick.box: starts 0.01 m inside obstacle.ball: move"})
        EXPECT_NE(inside.err.find(part), std::string::npos) << inside.err;
    EXPECT_EQ(outcome(0.1).err.find("obstacle.thing"), std::string::npos) << "it lies on the floor";
    EXPECT_EQ(outcome(0.3).exit_code, 0);
}

}  // namespace
}  // namespace sherd::test
