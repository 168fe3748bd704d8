// SPDX-License-Identifier: GPL-3.0-or-later
// A program may intervene in a simulation between two steps.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd {
namespace {

constexpr double step = 1e-3;  // s

SheetInput square() {
    SheetInput sheet;
    sheet.mesh = generate_rectangle(0.4, 0.4, {0.1, Layout::structured, 1});
    sheet.material = {2400, 0.004, 7e8, 0.2};
    return sheet;
}

SimulationOptions options_of(Scheme scheme) {
    SimulationOptions options;
    options.stepper.scheme = scheme;
    options.stepper.step = step;
    options.stepper.gravity.setZero();
    options.stepper.shell.given_forces = true;
    return options;
}

/// The edges of the line x = 0.2, which divides the square.
std::vector<Edge> middle_line(const Simulation& simulation) {
    const Mesh& mesh = simulation.shell().mesh();
    std::vector<Edge> edges;
    for (const Edge edge : mesh.edges())
        if (std::abs(mesh.point(mesh.vertex(edge, 0)).x() - 0.2) < 1e-9 &&
            std::abs(mesh.point(mesh.vertex(edge, 1)).x() - 0.2) < 1e-9)
            edges.push_back(edge);
    return edges;
}

class Interventions : public testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Schemes, Interventions,
                         testing::Values(Scheme::implicit_euler, Scheme::bdf2, Scheme::explicit_differences));

// Forces from a program must accelerate the sheet as given.
TEST_P(Interventions, ForcesAccelerate) {
    Simulation simulation({square()}, options_of(GetParam()));
    const Shell& shell = simulation.shell().mechanics();
    const Vector3d acceleration(3, -1, 2);
    simulation.give_forces(acceleration * shell.mass.transpose());
    StepReport report;
    for (int i = 0; i < 10; ++i) report = simulation.step();
    const Vector3d gained = report.linear_momentum / shell.mass.sum();
    // An explicit step uses new forces from the end of its first substep on.
    EXPECT_LT((gained - acceleration * simulation.time()).norm(), 0.05 * gained.norm());
    EXPECT_GT(report.work_of_loads, 0);
    EXPECT_NEAR(report.unexplained, 0, 1e-9 * report.work_of_loads);
    simulation.give_forces(Positions::Zero(3, shell.mass.size()));
    for (int i = 0; i < 25; ++i) simulation.step();  // until the history of multistep schemes is uniform
    const Vector3d before = simulation.step().linear_momentum;
    EXPECT_TRUE(simulation.step().linear_momentum.isApprox(before, 1e-9));
}

TEST_P(Interventions, PinnedVerticesGoAsTheyAreTold) {
    SheetInput sheet = square();
    sheet.pinned = {0, 1};
    SimulationOptions options = options_of(GetParam());
    options.supported_vertices = {{0, {}}, {1, {}}};
    for (SupportedVertex& vertex : options.supported_vertices) vertex.by = {{0, Matrix3d::Identity()}};
    options.stepper.supports = 1;
    Simulation simulation({sheet}, options);
    const std::vector<Index> told{1, 0};
    Positions places(3, 2);
    for (int i = 1; i <= 4; ++i) {
        for (int k = 0; k < 2; ++k)
            places.col(k) =
                Vector3d(simulation.shell().mechanics().rest.col(told[k])) + Vector3d(0, 1e-4 * k, 1e-4 * i);
        simulation.prescribe(told, places, i * step);
        simulation.step();
        for (int k = 0; k < 2; ++k)
            EXPECT_LT((simulation.shell().mechanics().position.col(told[k]) - places.col(k)).norm(), 1e-15);
    }
    simulation.step();
    EXPECT_LT((simulation.shell().mechanics().position.col(1) - places.col(0)).norm(), 1e-15);
    EXPECT_EQ(simulation.shell().mechanics().motions.size(), 2u);
    EXPECT_NE(test::message_thrown_by([&] {
                  simulation.prescribe(std::array{Index{2}}, places.leftCols(1), 1);
              }).find("vertex 2 cannot follow prescribed positions"),
              std::string::npos);
}

// Edges that are broken by hand must be opened, numbered and recorded like other failed edges.
TEST_P(Interventions, EdgesBreakBetweenSteps) {
    for (const int steps : {0, 2}) {
        Simulation simulation({square()}, options_of(GetParam()));
        for (int i = 0; i < steps; ++i) simulation.step();
        simulation.take_events();
        const std::vector<Edge> line = middle_line(simulation);
        ASSERT_EQ(line.size(), 4u);
        simulation.break_by_hand(line);
        const CrackEvents events = simulation.take_events();
        EXPECT_EQ(events.failures.size(), 4u);
        EXPECT_EQ(events.openings.size(), 4u);
        EXPECT_EQ(events.splits.size(), 5u);
        ASSERT_EQ(events.fragment_splits.size(), 1u);
        EXPECT_EQ(events.fragment_splits[0].step, steps);
        EXPECT_EQ(events.fragment_splits[0].time, simulation.time());
        const Snapshot snapshot = simulation.snapshot();
        EXPECT_EQ(*std::ranges::max_element(snapshot.face_fragment), 1);
        EXPECT_EQ(simulation.step().fragments, 2);
    }
}

TEST_P(Interventions, WhatAHingeStoredIsLost) {
    Simulation simulation({square()}, options_of(GetParam()));
    const Shell& shell = simulation.shell().mechanics();
    Positions forces = Positions::Zero(3, shell.mass.size());
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v)
        forces(2, v) = shell.mass[v] * (std::abs(shell.rest(0, v) - 0.2) < 1e-9 ? 2000 : -500);
    simulation.give_forces(forces);
    StepReport before;
    for (int i = 0; i < 5; ++i) before = simulation.step();
    simulation.break_by_hand(middle_line(simulation));
    const StepReport after = simulation.step();
    EXPECT_GT(after.lost_to_cracks, 0.01 * before.bending);
    EXPECT_NEAR(after.unexplained, before.unexplained, 0.05 * after.lost_to_cracks);
}

TEST(BreakingByIntervention, WhatCannotFailIsSaid) {
    Simulation simulation({square()}, options_of(Scheme::implicit_euler));
    std::vector<Edge> line = middle_line(simulation);
    line.push_back(line.front());
    EXPECT_NE(test::message_thrown_by([&] { simulation.break_by_hand(line); }).find("is given twice"),
              std::string::npos);
    EXPECT_TRUE(simulation.take_events().failures.empty());
    line.pop_back();
    simulation.break_by_hand(line);
    EXPECT_NE(test::message_thrown_by([&] { simulation.break_by_hand(line); }).find("has failed already"),
              std::string::npos);
    EXPECT_NE(test::message_thrown_by([&] {
                  simulation.give_forces(Positions::Zero(3, 2));
              }).find("for 2 vertices"),
              std::string::npos);
}

}  // namespace
}  // namespace sherd
