// SPDX-License-Identifier: GPL-3.0-or-later
// Length of a step that resolves the propagation of cracks. Computed from a wrong sheet or wrong edges, it
// would be needlessly short, or too long for the propagation to be seen.
#include "fracture/cracks/resolving_step.h"

#include <gtest/gtest.h>

#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

/// m; every face has the sides 3, 4 and 5 times this
constexpr double unit = 0.001;

SheetInput grid(double speed_limit) {
    SheetInput input;
    input.mesh = generate_rectangle(8 * unit, 6 * unit, {4 * unit, Layout::structured, 1});
    for (const Vertex vertex : input.mesh.vertices()) {
        const Point p = input.mesh.point(vertex);
        input.mesh.point(vertex) =
            Point(std::round(p.x() / (4 * unit)) * 4 * unit, std::round(p.y() / (3 * unit)) * 3 * unit, 0);
    }
    input.material = test::glass;
    if (speed_limit == 0) return input;
    input.strength = uniform_strength(4e7, Measure::stress);
    input.toughness.value = 1e6;
    input.toughness.speed_limit = speed_limit;
    return input;
}

TEST(ResolvingStep, IsTheTimeOfAMeanEdgeAtTheSpeedLimit) {
    const std::optional<double> step = resolving_step(BreakableShell({grid(2000)}));
    ASSERT_TRUE(step);
    EXPECT_NEAR(*step, 4 * unit / 2000, 1e-15);
}

TEST(ResolvingStep, IsTheLeastOfTheSheetsThatHaveAToughness) {
    EXPECT_FALSE(resolving_step(BreakableShell({grid(0)})));
    EXPECT_NEAR(*resolving_step(BreakableShell({grid(1000), grid(0), grid(4000), grid(2000)})),
                4 * unit / 4000, 1e-15);
}

}  // namespace
}  // namespace sherd
