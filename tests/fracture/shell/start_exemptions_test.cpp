// SPDX-License-Identifier: GPL-3.0-or-later
// Artists' meshes intersect themselves. Such a sheet must move without contact there, keep its energy, and
// collide again once it is apart.
#include "fracture/shell/start_exemptions.h"

#include <gtest/gtest.h>

#include "fracture/shell/start_overlaps.h"
#include "fracture/step/simulation.h"
#include "tests/support/mesh/tilted_square.h"

namespace sherd {
namespace {

using test::tilted_square;

constexpr double sheet_thickness = 0.01;  // m

SimulationOptions weightless(double step) {
    SimulationOptions options;
    options.stepper.step = step;
    options.stepper.gravity = Vector3d::Zero();
    options.stepper.contact.sheets = true;
    return options;
}

BreakableShell exempt(const std::vector<SheetInput>& inputs) {
    BreakableShell sheets(inputs);
    sheets.exempt(start_overlaps(sheets));
    return sheets;
}

/// Two squares that cross at right angles, the second one `deep` m below the first; it starts with
/// `velocity`, m/s.
std::vector<SheetInput> crossing_squares(const Vector3d& velocity, double deep = 0.53) {
    std::vector<SheetInput> inputs{tilted_square(0, {0, 0, 0}, 0.25),
                                   tilted_square(90, {0.1, 0.43, -deep}, 0.25)};
    inputs[1].velocity = velocity;
    return inputs;
}

TEST(StartExemptions, NothingOverlapsThatIsExempt) {
    EXPECT_FALSE(start_overlaps(BreakableShell(crossing_squares({0, 0, 0}))).empty());
    EXPECT_TRUE(start_overlaps(exempt(crossing_squares({0, 0, 0}))).empty());
    const std::vector<SheetInput> near{tilted_square(0, {0, 0, 0}, 0.25),
                                       tilted_square(0, {0.1, 0.1, 0.004})};
    EXPECT_TRUE(start_overlaps(exempt(near)).empty());
}

// Contact forces between intersecting sheets have no right direction: any of them would add energy.
TEST(StartExemptions, SheetsThatCrossRestWhereTheyAre) {
    Simulation simulation(exempt(crossing_squares({0, 0, 0})), weightless(1e-3));
    const Positions start = simulation.shell().mechanics().position;
    StepReport report;
    for (int i = 0; i < 5; ++i) report = simulation.step();
    EXPECT_LT((simulation.shell().mechanics().position - start).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_GT(report.exempt_pairs, 0);
    EXPECT_LT(std::abs(report.unexplained), 1e-12);
}

// The second square, which reaches through one row of faces only, leaves upwards: then it must be able to
// collide again.
TEST(StartExemptions, TheyPartAndAreSeenFromThenOn) {
    Simulation simulation(exempt(crossing_squares({0, 0, 2}, 0.1)), weightless(1e-2));
    const double energy = 0.5 * 1000 * sheet_thickness * 2 * 2;  // J, of 1 m^2
    StepReport report;
    for (int i = 0; i < 40; ++i) {
        report = simulation.step();
        EXPECT_LE(report.kinetic, energy * (1 + 1e-9));
    }
    EXPECT_EQ(report.exempt_pairs, 0);
    EXPECT_TRUE(simulation.shell().mechanics().exempt_pairs.empty());
    EXPECT_LT(std::abs(report.unexplained), 1e-6 * energy);
    EXPECT_TRUE(start_overlaps(simulation.shell()).empty());
}

// Where faces beside the intersection, which were apart at the start, would have to pass each other, their
// contact must stop the intersecting sheets, and not throw them.
TEST(StartExemptions, TheirNeighboursStopThem) {
    Simulation simulation(exempt(crossing_squares({0, 0, 2})), weightless(1e-2));
    const double energy = 0.5 * 1000 * sheet_thickness * 2 * 2;
    StepReport report;
    for (int i = 0; i < 40; ++i) {
        report = simulation.step();
        EXPECT_LE(report.kinetic, energy * (1 + 1e-9));
    }
    EXPECT_GT(report.exempt_pairs, 0);
    EXPECT_LT(std::abs(report.unexplained), 1e-6 * energy);
}

// Sheets that overlap without intersecting must carry each other at their initial distance.
TEST(StartExemptions, WhatIsTooNearIsPushedBackWhereItWas) {
    const double apart = 0.6 * sheet_thickness;
    std::vector<SheetInput> inputs{tilted_square(0, {0, 0, 0}, 0.25),
                                   tilted_square(0, {0.07, 0.05, apart}, 0.25)};
    for (const Vertex v : inputs[0].mesh.vertices()) inputs[0].pinned.push_back(static_cast<Index>(v));
    inputs[1].velocity = {0, 0, -0.5};
    Simulation simulation(exempt(inputs), weightless(1e-3));
    const Index first = static_cast<Index>(inputs[0].mesh.number_of_vertices());
    const double energy = 0.5 * 1000 * sheet_thickness * 0.5 * 0.5;
    StepReport report;
    for (int i = 0; i < 400 && (i == 0 || report.exempt_pairs > 0); ++i) {
        report = simulation.step();
        const Positions& x = simulation.shell().mechanics().position;
        EXPECT_GT(x.row(2).tail(x.cols() - first).minCoeff(), 0.7 * apart) << "it went through";
        EXPECT_LE(report.kinetic, energy * (1 + 1e-9)) << "it was flung away";
    }
    EXPECT_EQ(report.exempt_pairs, 0) << "it has not bounced off";
    EXPECT_GT(report.linear_momentum.z(), 0);
}

// A crack through an exempt place must not make intersecting faces collide.
TEST(StartExemptions, CopiesOfACrackAreExemptToo) {
    BreakableShell sheets = exempt(crossing_squares({0, 0, 0}));
    const std::size_t before = sheets.exempt_pairs();
    std::vector<Edge> cut;
    for (const Edge edge : sheets.mesh().edges())
        if (sheets.sheet_of(edge) == 0 && !sheets.mesh().is_border(edge)) cut.push_back(edge);
    sheets.fail(cut);
    EXPECT_GT(sheets.exempt_pairs(), before);
    EXPECT_TRUE(start_overlaps(sheets).empty()) << "a copy of an exempt vertex was seen at once";
}

}  // namespace
}  // namespace sherd
