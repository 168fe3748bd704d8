// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/tip_speeds.h"

#include <gtest/gtest.h>

#include "app/measures/cracks/crack_graph.h"
#include "app/measures/energy_extent.h"
#include "tests/support/recording/broken_grid.h"

namespace sherd::test {
namespace {

constexpr Index tip_squares = 10;

/// Propagates a crack along y = 5, in one step, from the vertex at x = `from` to the vertex at x = `to`.
void fail(CrackEvents& events, std::int64_t step, Index from, Index to) {
    for (Index x = from; x < to; ++x)
        events.failures.push_back(
            {.step = step, .vertices = {grid_vertex(tip_squares, x, 5), grid_vertex(tip_squares, x + 1, 5)}});
}

/// Steps 1, 2 and 3, which are 0.1 s, 0.2 s and 0.1 s long.
std::vector<StepReport> three_steps() {
    std::vector<StepReport> steps(3);
    for (int i = 0; i < 3; ++i) steps[i].step = i + 1;
    steps[0].time = steps[0].step_size = 0.1;
    steps[1].time = 0.3, steps[1].step_size = 0.2;
    steps[2].time = 0.4, steps[2].step_size = 0.1;
    return steps;
}

TipSpeeds speeds_of(const CrackEvents& events) {
    const Snapshot frame = grid_sheet(tip_squares, tip_squares);
    return tip_speeds(events, three_steps(), frame, crack_graph(frame).on_rim);
}

// A crack that starts inside has two tips; a crack that comes from another crack or from the rim has one.
TEST(TipSpeeds, AreLengthOverTimeAtEachNewEnd) {
    CrackEvents events;
    fail(events, 1, 3, 5);   // two edges, two tips: 10 m/s each
    fail(events, 2, 5, 6);   // continued: 5 m/s
    fail(events, 3, 6, 10);  // to the rim: 40 m/s
    fail(events, 3, 0, 1);   // from the rim: 10 m/s
    const TipSpeeds speeds = speeds_of(events);
    ASSERT_EQ(speeds.steps.size(), 3u);
    EXPECT_FALSE(speeds.recorded);
    EXPECT_EQ(speeds.steps[0].tips, 2u);
    EXPECT_NEAR(speeds.steps[0].length, 2, 1e-12);
    EXPECT_NEAR(speeds.steps[0].speed, 10, 1e-12);
    EXPECT_EQ(speeds.steps[1].tips, 1u);
    EXPECT_NEAR(speeds.steps[1].speed, 5, 1e-12);
    EXPECT_EQ(speeds.steps[2].tips, 2u);
    EXPECT_NEAR(speeds.steps[2].speed, 25, 1e-12);
    EXPECT_NEAR(speeds.fastest().fastest, 40, 1e-12);
    EXPECT_EQ(speeds.fastest().time, 0.4);
    EXPECT_NEAR(speeds.mean(), 8 / (2 * 0.1 + 0.2 + 2 * 0.1), 1e-12);
}

// Speeds that are recorded for tips are more exact than the length of failed edges in a step. Arrested tips
// do not count.
TEST(TipSpeeds, AreThoseOfRecordsWhereThereAreAny) {
    CrackEvents events;
    fail(events, 1, 3, 5);
    for (const auto& [tip, speed] : {std::pair{0, 300.0}, std::pair{1, 500.0}, std::pair{2, 0.0}})
        events.tips.push_back({.step = 1, .tip = tip, .speed = speed});
    const TipSpeeds speeds = speeds_of(events);
    ASSERT_EQ(speeds.steps.size(), 1u);
    EXPECT_TRUE(speeds.recorded);
    EXPECT_EQ(speeds.steps[0].tips, 2u);
    EXPECT_EQ(speeds.steps[0].speed, 400);
    EXPECT_EQ(speeds.steps[0].fastest, 500);
    EXPECT_NEAR(speeds.steps[0].length, 2, 1e-12);
    EXPECT_EQ(speeds_of({}).mean(), 0);
    EXPECT_EQ(speeds_of({}).fastest().fastest, 0);
}

TEST(EnergyExtent, IsLastAndLargestInMagnitudeOfEachColumn) {
    std::vector<StepReport> steps = three_steps();
    steps[0].kinetic = 1, steps[1].kinetic = 5, steps[2].kinetic = 2;
    steps[1].gravity = -7, steps[2].gravity = 3;
    steps[2].lost_to_cracks = 0.5;
    const auto find = [](const std::vector<EnergyExtent>& extents, const std::string& name) {
        for (const EnergyExtent& extent : extents)
            if (extent.name == name) return extent;
        return EnergyExtent{};
    };
    const std::vector<EnergyExtent> all = energy_extents(steps, true);
    EXPECT_EQ(find(all, "kinetic").last, 2);
    EXPECT_EQ(find(all, "kinetic").largest, 5);
    EXPECT_EQ(find(all, "kinetic").time, 0.3);
    EXPECT_EQ(find(all, "gravity").largest, -7);
    EXPECT_EQ(find(all, "lost_to_cracks").last, 0.5);
    EXPECT_EQ(find(all, "step_size").name, "");  // a length of time, not an energy
    EXPECT_EQ(find(energy_extents(steps, false), "lost_to_cracks").name, "");
    EXPECT_EQ(energy_extents(steps, false).size(), 6u);
    EXPECT_TRUE(energy_extents({}, true).empty());
}

}  // namespace
}  // namespace sherd::test
