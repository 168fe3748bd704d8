// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/near_surface.h"

#include <gtest/gtest.h>

#include "core/contact/geometry/distance.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

// A missed vertex would collide with a surface across which it starts; a vertex found by mistake would never
// collide with the surface.
TEST(NearSurface, FindsWhatLookingAtAllTrianglesFinds) {
    test::Random random(7);
    const Positions points = Positions::Random(3, 40), x = Positions::Random(3, 200);
    std::vector<std::array<Index, 3>> triangles;
    for (Index t = 0; t < 38; ++t) triangles.push_back({t, t + 1, t + 2});
    VectorXd reach(x.cols());
    for (double& r : reach) r = random.uniform(-0.1, 0.3);
    std::vector<Index> expected;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        double nearest = 10;
        for (const auto& triangle : triangles) {
            PairPositions pair;
            pair << x.col(v), columns(points, triangle);
            nearest =
                std::min(nearest, squared_distance(closest_points(PairKind::vertex_triangle, pair), pair));
        }
        if (std::sqrt(nearest) < reach[v]) expected.push_back(v);
    }
    ASSERT_GT(expected.size(), 10u);
    EXPECT_EQ(near_surface(points, triangles, x, reach), expected);
}

}  // namespace
}  // namespace sherd
