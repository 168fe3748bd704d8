// SPDX-License-Identifier: GPL-3.0-or-later
// In explicit steps a fragment, even a single face, must not vibrate faster than the substep permits: its
// energy would grow without bound within a step, and throw fragments about.
#include <gtest/gtest.h>

#include <cmath>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"

namespace sherd::test {
namespace {

TEST(BreakingEnergy, OfABowlThatFallsOnStoneIsNotMade) {
    const Scene scene = read_scene(
        shipped_scene("experiments/dropped_bowl", shipped_scenes(shipped_scene_folder())).file, {});
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    Simulation simulation(std::move(built.sheets), built.options);
    StepReport report = simulation.step();
    const double start = report.kinetic;
    while (simulation.time() < 2e-4) {
        report = simulation.step();
        ASSERT_LT(std::abs(report.lost_to_scheme), 0.01 * start) << "at " << simulation.time() << " s";
    }
    EXPECT_GT(report.fragments, 3) << "has broken";
}

}  // namespace
}  // namespace sherd::test
