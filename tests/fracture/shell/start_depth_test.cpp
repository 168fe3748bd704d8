// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that start in an obstacle must neither be thrown out of it, with too much energy, nor fall through
// it.
#include "core/contact/colliders/start_depth.h"

#include <gtest/gtest.h>

#include "fracture/step/simulation.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/mesh/tilted_square.h"

namespace sherd {
namespace {

using test::tilted_square;

constexpr double half = 0.005;  // m, half of the thickness
constexpr double mass = 10;     // kg

Obstacle floor_at(double height) {
    return test::obstacle(PlaneShape({0, 0, height}, Vector3d::UnitZ()), 1e9);
}

SimulationOptions on_floor(Scheme scheme, double height) {
    SimulationOptions options;
    options.stepper.scheme = scheme;
    options.stepper.step = 1e-3;
    options.stepper.gravity = {0, 0, -9.81};
    options.stepper.contact.obstacles = {floor_at(height)};
    return options;
}

/// Square at height 0 whose vertices may stay in the obstacle below as deep as they start, `depth` m, and
/// which starts upwards at `speed` m/s.
BreakableShell sunk(double depth, double speed = 0, bool surface_exempt = false) {
    SheetInput input = tilted_square(0, {0, 0, 0}, 0.25);
    input.velocity = {0, 0, speed};
    BreakableShell sheet({input});
    for (Index v = 0; v < static_cast<Index>(sheet.mechanics().mass.size()); ++v)
        exempt_overlap(sheet.mechanics(), 1, 0, v, depth, surface_exempt);
    return sheet;
}

double lowest(const Simulation& simulation) {
    return simulation.shell().mechanics().position.row(2).minCoeff();
}

TEST(StartDepth, APlateInTheFloorRestsThere) {
    for (const Scheme scheme : {Scheme::implicit_euler, Scheme::explicit_differences}) {
        Simulation simulation(sunk(1e-3 + half), on_floor(scheme, 1e-3));
        StepReport report;
        for (int i = 0; i < 20; ++i) {
            report = simulation.step();
            EXPECT_LT(report.kinetic, 1e-5) << "it was flung out";
            EXPECT_LT(std::abs(report.unexplained), 1e-9);
        }
        EXPECT_NEAR(lowest(simulation), 0, 1e-6);
        EXPECT_FALSE(simulation.shell().mechanics().start_depths.empty());
    }
}

// The first substep must be short enough for a contact that weight causes within it: a substep chosen
// without gravity threw a plate of 10 kg up at 0.16 m/s.
TEST(StartDepth, APlateThatTouchesTheFloorRestsInExplicitSteps) {
    Simulation simulation({tilted_square(0, {0, 0, half}, 0.25)}, on_floor(Scheme::explicit_differences, 0));
    for (int i = 0; i < 20; ++i) EXPECT_LT(simulation.step().kinetic, 1e-5);
    EXPECT_NEAR(lowest(simulation), half, 1e-6);
}

// A plate that is thrown up out of the floor must land on it like any other plate.
TEST(StartDepth, WhatCameOutStaysOut) {
    Simulation simulation(sunk(1e-3 + half, 0.4), on_floor(Scheme::implicit_euler, 1e-3));
    const double energy = 0.5 * mass * 0.4 * 0.4;
    double highest = 0;
    for (int i = 0; i < 150; ++i) {
        const StepReport report = simulation.step();
        EXPECT_LE(report.kinetic, energy * (1 + 1e-9));
        highest = std::max(highest, lowest(simulation));
    }
    EXPECT_GT(highest, 6.5e-3) << "it never came out";
    EXPECT_TRUE(simulation.shell().mechanics().start_depths.empty());
    EXPECT_GT(lowest(simulation), 1e-3 + 0.9 * half) << "it sank into the floor again";
}

// A start depth that has shrunk must not grow again.
TEST(StartDepth, OnlyShrinks) {
    BreakableShell sheet = sunk(2e-3 + half, 0, true);
    Shell& shell = sheet.mechanics();
    const std::vector<Obstacle> floor{floor_at(2e-3)};
    shell.position.row(2).setConstant(1e-3);
    EXPECT_FALSE(shrink_start_depths(shell, floor, {}, 0));
    EXPECT_NEAR(start_depth(shell, 0, 0), 1e-3 + half, 1e-15);
    shell.position.row(2).setConstant(0);
    shrink_start_depths(shell, floor, {}, 0);
    EXPECT_NEAR(start_depth(shell, 0, 0), 1e-3 + half, 1e-15);
    shell.position.row(2).setConstant(0.5);
    EXPECT_TRUE(shrink_start_depths(shell, floor, {}, 0)) << "it can meet the surface again";
    EXPECT_TRUE(shell.start_depths.empty());
}

// Copies made by a crack must have the depth of their originals, so that contact does not throw them out.
TEST(StartDepth, PassesOnToCopies) {
    BreakableShell sheet = sunk(1e-3 + half);
    const Index before = static_cast<Index>(sheet.mechanics().mass.size());
    std::vector<Edge> inner;
    for (const Edge edge : sheet.mesh().edges())
        if (!sheet.mesh().is_border(edge)) inner.push_back(edge);
    sheet.fail(inner);
    ASSERT_GT(static_cast<Index>(sheet.mechanics().mass.size()), before);
    for (Index v = 0; v < static_cast<Index>(sheet.mechanics().mass.size()); ++v)
        EXPECT_EQ(start_depth(sheet.mechanics(), 0, v), 1e-3 + half);
}

}  // namespace
}  // namespace sherd
