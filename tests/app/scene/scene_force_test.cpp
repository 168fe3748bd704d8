// SPDX-License-Identifier: GPL-3.0-or-later
// A load or a support that is wrong or missing makes a run worthless without a message.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/read/forces.h"
#include "meshops/error.h"
#include "tests/support/program/built_text.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

// Scene of a plate with 0 <= x <= 2 and 0 <= y <= 1, m.
const std::string plate = R"(duration = 0.1
[sheet.plate]
mesh = { generate = "rectangle", width = 2, height = 1, edge_length = 0.25 }
material = { density = 1000, thickness = 0.01, young = 1e8, poisson = 0 }
)";

struct Prepared {
    Scene scene;
    std::vector<SheetInput> inputs;
    SimulationOptions options;
};

Prepared prepare(const std::string& text) {
    BuiltText all = built_from(text);
    return {std::move(all.scene), std::move(all.built.inputs), std::move(all.built.options)};
}

std::string force_message(const std::string& text) {
    return message_thrown_by([&] { prepare(text); });
}

Vector3d total(const Load& load) {
    Vector3d sum = Vector3d::Zero();
    for (const CornerForce& dead : load.dead) sum += dead.force;
    for (const FaceForce& spread : load.spread) sum += spread.force;
    return sum;
}

TEST(SceneForce, LoadsArriveWithTheirUnits) {
    const Prepared prepared = prepare(plate + R"([[force.load]]
line = [0, 0, 3]
box = [[1.999, -1, -1], [2.001, 2, 1]]
ramp = 0.5
[[force.load]]
area = [1, 2, 0]
[[force.load]]
pressure = -7
sheet = "plate"
[[force.load]]
point = [0, 5, 0]
box = [[-0.001, -0.001, -1], [0.001, 0.001, 1]]
[solver]
damping = { stiffness = 1e-4, mass = 2 }
)");
    const std::vector<Load>& loads = prepared.options.stepper.shell.loads;
    ASSERT_EQ(loads.size(), 4u);
    EXPECT_LT((total(loads[0]) - Vector3d(0, 0, 3)).norm(), 1e-12) << "the right side is 1 m long";
    EXPECT_EQ(loads[0].ramp, 0.5);
    EXPECT_LT((total(loads[1]) - Vector3d(2, 4, 0)).norm(), 1e-12) << "the plate has 2 m^2";
    EXPECT_EQ(loads[2].pressed.size(), prepared.inputs[0].mesh.number_of_faces());
    EXPECT_EQ(loads[2].pressure, -7);
    EXPECT_LT((total(loads[3]) - Vector3d(0, 5, 0)).norm(), 1e-12) << "one corner";
    EXPECT_EQ(prepared.options.stepper.shell.damping.stiffness, 1e-4);
    EXPECT_EQ(prepared.options.stepper.shell.damping.mass, 2);
}

TEST(SceneForce, AMomentArrivesOnTheBoundary) {
    const Prepared prepared = prepare(plate + R"([[force.load]]
moment = 3
sheet = "plate"
ramp = 2
box = [[1.999, -1, -1], [2.001, 2, 1]]
)");
    ASSERT_EQ(prepared.options.stepper.shell.loads.size(), 1u);
    const Load& load = prepared.options.stepper.shell.loads[0];
    EXPECT_EQ(load.ramp, 2);
    double sum = 0;
    for (const EdgeMoment& moment : load.moments) {
        EXPECT_LT((moment.axis - Vector3d::UnitY()).norm(), 1e-12) << "counterclockwise around the sheet";
        sum += moment.moment;
    }
    EXPECT_NEAR(sum, 3, 1e-12) << "the right side is 1 m long";
    EXPECT_NE(
        force_message(plate + "[[force.load]]\nmoment = [0, 0, 1]\n").find("moment: must be a finite number"),
        std::string::npos);
    EXPECT_NE(force_message(plate + "[[force.load]]\nmoment = 1\nbox = [[8, 8, 8], [9, 9, 9]]\n")
                  .find("edge of the boundary"),
              std::string::npos);
}

// The plate is a quarter of a larger one, behind two symmetry planes: vertices must stay in these planes
// while the plate falls from its clamp.
TEST(SceneSupport, ClampsAndSymmetryPlanesHoldThroughARun) {
    const Prepared prepared = prepare(plate + R"(clamp = { box = [[-1e-6, -1, -1], [1e-6, 2, 1]] }
symmetry = [{ point = [0, 1, 0], normal = [0, 2, 0] }, { point = [2, 0, 0], normal = [1, 0, 0] }]
[solver]
step = 1e-2
)");
    Simulation simulation(prepared.inputs, prepared.options);
    for (int i = 0; i < 10; ++i) simulation.step();
    const Shell& sheet = simulation.shell().mechanics();
    double drop = 0;
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
        const Vector3d rest = sheet.rest.col(v), now = sheet.position.col(v);
        if (rest.x() < 1e-6) {
            EXPECT_EQ(now, rest);
        }
        if (rest.y() > 1 - 1e-9) {
            EXPECT_EQ(now.y(), rest.y());
        }
        if (rest.x() > 2 - 1e-9) {
            EXPECT_EQ(now.x(), rest.x());
        }
        drop = std::max(drop, -now.z());
    }
    EXPECT_GT(drop, 1e-3);
}

// Pins like roller bearings: vertices must move in the free directions, and in no others. With several
// supports, a vertex is free in the directions that all of them leave free.
TEST(SceneSupport, PinsLeaveDirectionsFree) {
    const Prepared prepared = prepare(plate + R"(pin = [
    { box = [[-1e-6, -1, -1], [1e-6, 2, 1]], free = ["x", "y"] },
    { box = [[1.999, -1, -1], [2.001, 2, 1]], free = ["z"] },
    { box = [[-1e-6, -1e-6, -1], [1e-6, 1e-6, 1]], free = ["y"] },
    { box = [[1.999, -1e-6, -1], [2.001, 1e-6, 1]], free = ["x", "y"] } ]
symmetry = { point = [0, 1, 0], normal = [0, 1, 0] }
[force]
gravity = [-1, 1, -9.81]
[solver]
step = 1e-2
)");
    EXPECT_TRUE(prepared.inputs[0].pinned.empty());
    EXPECT_EQ(partly_pinned_vertices(prepared.scene.sheets[0], prepared.inputs[0].mesh), 10u) << "two sides";
    Simulation simulation(prepared.inputs, prepared.options);
    for (int i = 0; i < 5; ++i) simulation.step();
    const Shell& sheet = simulation.shell().mechanics();
    Vector3d left = Vector3d::Zero(), right = left;
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
        const Vector3d rest = sheet.rest.col(v), way = Vector3d(sheet.position.col(v)) - rest;
        if (rest.x() < 1e-6) {
            EXPECT_EQ(way.z(), 0);
            if (rest.y() < 1e-6) {
                EXPECT_EQ(way.x(), 0) << "two pins leave y alone";
            }
            if (rest.y() > 1 - 1e-6) {
                EXPECT_EQ(way.y(), 0) << "a pin and a plane leave x alone";
            }
            left = left.cwiseMax(way.cwiseAbs());
        }
        if (rest.x() > 1.999) {
            EXPECT_EQ(way.head<2>(), Vector2d(0, 0));
            if (rest.y() < 1e-6) {
                EXPECT_EQ(way.z(), 0) << "nothing is free for both pins";
            }
            right = right.cwiseMax(way.cwiseAbs());
        }
    }
    EXPECT_GT(left.x(), 1e-6);
    EXPECT_GT(left.y(), 1e-6);
    EXPECT_GT(right.z(), 1e-3);
}

TEST(SceneSupport, FreedomThatCannotBeIsRefused) {
    const auto says = [](const std::string& support, const std::string& wanted) {
        const std::string message = force_message(plate + support + "\n");
        EXPECT_NE(message.find("scene.toml:5: sheet.plate." + wanted), std::string::npos) << message;
    };
    says("pin = { boundary = true, free = [\"w\"] }", "pin.free: must be an array of one or more of \"x\"");
    says("pin = { boundary = true, free = [\"x\", \"x\"] }", "pin.free: must be an array");
    says("pin = { boundary = true, free = [] }", "pin.free: must be an array");
    says("pin = { boundary = true, free = [\"x\", \"y\", \"z\"] }", "pin.free: holds nothing");
    says("pin = { boundary = true, free = [\"x\"], keys = [{ time = 0 }] }", "pin.free: conflicts with keys");
    says("clamp = { boundary = true, free = [\"x\"] }", "clamp.free: is for pins only");
}

// The left side turns about its own centre, and the right side about the given centre.
TEST(SceneSupport, PinsAndClampsMoveAsTheirKeysSay) {
    const Prepared prepared = prepare(plate + R"(
pin = { box = [[-1e-6, -1, -1], [1e-6, 2, 1]], motion = "linear", keys = [
    { time = 0 }, { time = 0.1, translate = [0.1, 0, 0], rotate = { axis = [1, 0, 0], degrees = 90 } } ] }
clamp = { box = [[1.999, -1, -1], [3, 2, 1]], centre = [2, 0, 0], keys = [
    { time = 0.02 }, { time = 0.04, rotate = { axis = [0, 1, 0], degrees = -90 } } ] }
[solver]
step = 5e-3
)");
    Simulation simulation(prepared.inputs, prepared.options);
    const Shell& sheet = simulation.shell().mechanics();
    const auto expect_place = [&](double x, const Vector3d& centre, const Vector3d& way,
                                  const Vector3d& turn) {
        for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
            if (std::abs(sheet.rest(0, v) - x) > 1e-6) continue;
            const Vector3d arm = Vector3d(sheet.rest.col(v)) - centre;
            const Vector3d turned =
                turn.isZero() ? arm : Eigen::AngleAxisd(turn.norm(), turn.normalized()) * arm;
            EXPECT_LT((sheet.position.col(v) - centre - way - turned).norm(), 1e-12);
        }
    };
    for (int i = 0; i < 4; ++i) simulation.step();
    expect_place(2, {2, 0, 0}, {0, 0, 0}, {0, 0, 0});
    for (int i = 0; i < 6; ++i) simulation.step();
    expect_place(0, {0, 0.5, 0}, {0.05, 0, 0}, {std::numbers::pi / 4, 0, 0});
    expect_place(2, {2, 0, 0}, {0, 0, 0}, {0, -std::numbers::pi / 2, 0});
    EXPECT_GT(linear_momentum(sheet).norm(), 0.1) << "the pinned vertices are a part of the momentum";
    for (const MirrorHinge& hinge : prepared.options.stepper.shell.mirrors) EXPECT_EQ(hinge.script, 2);
}

TEST(SceneSupport, MotionsThatCannotBeAreRefused) {
    const auto pin = [](const std::string& keys) {
        return force_message(plate + "pin = [{ boundary = true, " + keys + " }]\n");
    };
    const std::string later = "{ time = 1, translate = [0, 0, 1] }";
    const auto says = [](const std::string& message, const std::string& wanted) {
        EXPECT_NE(message.find("scene.toml:5: sheet.plate.pin" + wanted), std::string::npos) << message;
    };
    says(pin("keys = [" + later + "]"), "[0].keys: must begin where the sheet is placed");
    says(pin("keys = [{ time = 1 }, " + later + "]"), "[0].keys[1].time: must be later");
    says(pin("motion = \"linear\""), "[0].motion: needs keys");
    says(pin("centre = [0, 0, 0]"), "[0].centre: needs keys");
    says(pin("keys = [{ time = 0 }, " + later + "] }, { box = [[-1, -1, -1], [9, 9, 9]]"),
         "[1]: holds a vertex that");
}

TEST(SceneForce, WhatReachesNothingIsNamed) {
    const std::string far = "box = [[8, 8, 8], [9, 9, 9]]\n";
    EXPECT_NE(force_message(plate + "[[force.load]]\npressure = 1\n" + far).find("force.load"),
              std::string::npos);
    EXPECT_NE(force_message(plate + "[[force.load]]\nline = [1, 0, 0]\n" + far).find("edge of the boundary"),
              std::string::npos);
    EXPECT_NE(force_message(plate + "clamp = { box = [[-1, -1, -1], [1e-6, 1e-6, 1]] }\n").find("no tangent"),
              std::string::npos);
    EXPECT_NE(
        force_message(plate + "symmetry = { point = [5, 0, 0], normal = [1, 0, 0] }\n").find("symmetry"),
        std::string::npos);
}

TEST(SceneForce, ContradictionsAreRefused) {
    const auto load = [](const std::string& keys) {
        return force_message(plate + "[[force.load]]\n" + keys);
    };
    EXPECT_NE(load("pressure = 1\narea = [1, 0, 0]\n").find("conflicts"), std::string::npos);
    EXPECT_NE(load("ramp = 1\n").find("has no size"), std::string::npos);
    EXPECT_NE(load("pressure = 1\nsheet = \"plat\"\n").find("names no sheet"), std::string::npos);
    EXPECT_NE(load("point = [1, 0, 0]\n").find("acts on no vertex"), std::string::npos);
    EXPECT_NE(load("pressure = 1\nramp = -1\n").find("ramp"), std::string::npos);
}

}  // namespace
}  // namespace sherd::test
