// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet that starts bent must have the curvature of the scene, without stretch, and be unstressed when
// flat: otherwise it starts with a wrong energy.
#include <gtest/gtest.h>

#include <cmath>

#include "core/forces/shell_energies.h"
#include "tests/support/program/built_text.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/scene_of.h"

namespace sherd::test {
namespace {

/// Scene of a strip of 1 m by 0.2 m, 5 mm thick, that stands on its long side and has Poisson's ratio 0.
std::string bent_strip(const std::string& sheet, const std::string& more = "") {
    return R"(duration = 1
force.gravity = [0, 0, 0]
)" + more +
           R"([sheet.strip]
mesh = { generate = "rectangle", width = 1, height = 0.2, edge_length = 0.05 }
place = { rotate = { axis = [1, 0, 0], degrees = 90 }, translate = [0, 0, 3] }
material = { density = 1000, thickness = 0.005, young = 1e9, poisson = 0 }
)" + sheet;
}

TEST(SceneBend, RollsTheSheetTowardsItsNormals) {
    const auto simulation = simulation_of(bent_strip("bend = { curvature = 2, from = [0.3, 0, 0] }\n"));
    const Shell& shell = simulation->shell().mechanics();
    const Vector3d normal(0, -1, 0);  // direction of the mesh's z axis, as placed
    for (Index v = 0; v < shell.rest.cols(); ++v) {
        const double s = shell.rest(0, v) - 0.3;
        const Vector3d expected =
            Vector3d(0.3 + std::sin(2 * s) / 2, 0, shell.rest(2, v)) + (1 - std::cos(2 * s)) / 2 * normal;
        EXPECT_LT((shell.position.col(v) - expected).norm(), 1e-14);
        EXPECT_NEAR(shell.rest(1, v), 0, 1e-15) << "flat at rest";
    }
}

TEST(SceneBend, HasTheEnergyOfTheCurvatureAndNoOther) {
    const auto simulation = simulation_of(bent_strip("bend = { curvature = 0.5 }\n", "solver.step = 1e-9\n"));
    const StepReport report = simulation->step();
    const double expected = 1e9 * std::pow(0.005, 3) / 12 * 0.5 * 0.5 / 2 * 0.2;
    EXPECT_NEAR(report.bending, expected, 0.05 * expected) << "four edges across: 4 % too little";
    EXPECT_LT(report.membrane, 2e-3 * expected) << "of chords, which are shorter than arcs";
    EXPECT_NEAR(report.unexplained, 0, 1e-9 * expected);
}

TEST(SceneBend, OfPinnedEndsHoldsThemWhereTheyStart) {
    const auto simulation = simulation_of(bent_strip(
        "bend = { curvature = 2 }\npin = { box = [[0.999, -1, 0], [2, 1, 9]] }\n", "solver.step = 1e-4\n"));
    const Positions start = simulation->shell().mechanics().position;
    for (int i = 0; i < 5; ++i) simulation->step();
    const Shell& shell = simulation->shell().mechanics();
    for (Index v = 0; v < start.cols(); ++v)
        EXPECT_EQ(shell.fixed[v] != 0, shell.position.col(v) == start.col(v)) << v;
}

// Obstacles must be compared with the positions of the sheet, not with its rest shape.
TEST(SceneBend, MeetsObstaclesWhereItStarts) {
    const auto beside = [](const char* bend) {
        return bent_strip(bend,
                          "contact.start = \"error\"\n"
                          "obstacle.ball.sphere = { radius = 0.1, centre = [1, 0, 3.1] }\n");
    };
    EXPECT_NE(message_thrown_by([&] { simulation_of(beside("")); }).find("obstacle.ball"), std::string::npos);
    EXPECT_EQ(message_thrown_by([&] { simulation_of(beside("bend = { curvature = 1.5 }\n")); }), "no error");
}

TEST(SceneBend, ThatCannotBeIsRefused) {
    const auto said = [](const std::string& sheet) {
        return message_thrown_by([&] { simulation_of(bent_strip(sheet)); });
    };
    EXPECT_NE(said("bend = { curvature = 1, along = [0, 0, 1] }\n").find("sheet.strip.bend.along: must not"),
              std::string::npos);
    EXPECT_NE(said("bend = { curvature = 1 }\n[[sheet.strip.pin]]\nboundary = true\n"
                   "keys = [{ time = 0 }, { time = 1 }]\n")
                  .find("sheet.strip.bend: conflicts with keys"),
              std::string::npos);
    EXPECT_NE(message_thrown_by([] {
                  simulation_of(
                      "duration = 1\n[sheet.tube]\nmesh = { generate = \"cylinder\", radius = 0.1, "
                      "height = 0.1, edge_length = 0.03 }\nmaterial.preset = \"steel\"\n"
                      "bend = { curvature = 1 }\n");
              }).find("sheet.tube.bend: needs a sheet that is flat"),
              std::string::npos);
}

}  // namespace
}  // namespace sherd::test
