// SPDX-License-Identifier: GPL-3.0-or-later
// In a sheet that is torn out of its plane the stress intensity factors at a tip are meaningless: if tips
// followed them, cracks would turn to the sides at once.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"

namespace sherd::test {
namespace {

TEST(BreakingFlap, CracksAroundATornFlapRunTogether) {
    const Scene scene =
        read_scene(shipped_scene("experiments/torn_flap", shipped_scenes(shipped_scene_folder())).file,
                   {{"sheet.plate.mesh.edge_length=0.003", "solver.load=0.45"}, ""});
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    Simulation simulation(std::move(built.sheets), built.options);
    simulation.take_events();
    while (simulation.time() < scene.duration) simulation.step();
    const Positions& rest = simulation.shell().mechanics().rest;
    Vector2d left(0, 0), right(0, 0);  // farthest points of the two cracks
    const CrackEvents events = simulation.take_events();
    for (const EdgeFailure& failure : events.failures)
        for (const Index v : failure.vertices) {
            Vector2d& end = rest(0, v) < 0 ? left : right;
            if (rest(1, v) > end.y()) end = rest.col(v).head<2>();
        }
    for (const Vector2d& end : {left, right}) {
        EXPECT_GT(end.y(), 0.034) << "from 0.03";
        EXPECT_LT(std::abs(end.x()), 0.0112) << "from 0.012";
        EXPECT_GT(std::abs(end.x()), 0.009);
    }
}

}  // namespace
}  // namespace sherd::test
