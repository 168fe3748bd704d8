// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene says of its obstacles must arrive as it was written, and what cannot be must be told with its
// line, before the run.
#include "app/scene_obstacle.h"

#include <gtest/gtest.h>

#include <numbers>

#include "app/scene_simulation.h"
#include "meshops/error.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace sherd::test {
namespace {

using std::numbers::pi;

const std::string plate = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { translate = [0, 0, 1] }
material = { preset = "stoneware" }
[obstacle.thing]
)";

Scene scene_of(const std::string& obstacle) {
    const TemporaryDirectory directory;
    return read_scene(directory.write("scene.toml", plate + obstacle));
}

Obstacle obstacle_of(const std::string& obstacle) {
    return make_obstacles(scene_of(obstacle)).at(0);
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

// Turned about the placed centre, not about the origin of the scene.
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

void expect_error(const std::string& obstacle, const std::vector<std::string>& parts) {
    try {
        scene_of(obstacle);
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
    expect_error("plane = {}\nplace = { move = [0, 0, 1] }",
                 {"scene.toml:8: obstacle.thing.place.move: unknown key"});
    expect_error("plane = {}\nplace.rotate = { axis = [0, 0, 0], degrees = 1 }",
                 {"place.rotate.axis: must not be zero"});
    expect_error("plane = {}\nkeys = [{ translate = [0, 0, 1] }]",
                 {"scene.toml:8: obstacle.thing.keys[0].time: is missing"});
    expect_error("plane = {}\nkeys = [{ time = 1 }, { time = 1 }]",
                 {"keys[1].time: must be later than that of the key before it (1 s)"});
    expect_error("plane = {}\nkeys = [{ time = 1, rotate = { axis = [0, 0, 1] } }]",
                 {"keys[0].rotate.degrees: is missing"});
    expect_error("plane = {}\nkeys = [{ time = 1, rotate = { axis = [0, 0, 0], degrees = 3 } }]",
                 {"keys[0].rotate.axis: must not be zero"});
    expect_error("plane = {}\nkeys = [{ time = 1, turn = 3 }]", {"keys[0].turn: unknown key"});
    expect_error("plane = {}\nmotion = \"smooth\"", {"scene.toml:8: obstacle.thing.motion: needs keys"});
    expect_error("plane = {}\nkeys = { time = 1 }\nmotion = \"smoth\"",
                 {"scene.toml:9: obstacle.thing.motion", "did you mean \"smooth\"?"});
}

// A sheet that starts inside would be shot out; the user must hear which, how far, and of what.
TEST(SceneObstacle, ASheetThatStartsInsideIsNamed) {
    const TemporaryDirectory directory;
    const auto outcome = [&](const std::string& command, double height) {
        directory.write("scene.toml", plate + "plane = { point = [0, 0, " + std::to_string(height) + "] }\n");
        return run_sherd({command, "scene.toml"}, directory.path);
    };
    for (const std::string command : {"check", "run"}) {
        const ProgramResult deep = outcome(command, 0.9995);
        EXPECT_EQ(deep.exit_code, 2) << deep.err;
        EXPECT_NE(deep.err.find("scene.toml:7: obstacle.thing.plane: "), std::string::npos) << deep.err;
        EXPECT_NE(deep.err.find(" vertices of sheet.plate start inside, vertex "), std::string::npos)
            << deep.err;
        EXPECT_NE(deep.err.find("the deepest, 0.0015 m beyond touching"), std::string::npos)
            << "4 mm thick: touching at 2 mm; " << deep.err;
    }
    EXPECT_FALSE(std::filesystem::exists(directory.path / "scene.h5"));
    const ProgramResult shallow = outcome("check", 0.9981);
    EXPECT_EQ(shallow.exit_code, 0) << shallow.err;
    EXPECT_NE(shallow.out.find("the deepest, 0.0001 m beyond touching"), std::string::npos) << shallow.out;
    EXPECT_EQ(outcome("check", 0.998).out.find("start inside"), std::string::npos) << "it lies on the plane";
}

}  // namespace
}  // namespace sherd::test
