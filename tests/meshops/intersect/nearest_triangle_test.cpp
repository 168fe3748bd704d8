// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/nearest_triangle.h"

#include <gtest/gtest.h>

#include <vector>

#include "meshops/error.h"

namespace sherd::test {
namespace {

// The number must count triangles that are omitted for having no area: without them it would be that of
// another face.
TEST(NearestTriangle, HasTheNumberAmongAll) {
    Eigen::Matrix3Xd points(3, 4);
    points << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
    const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 1}, {0, 1, 2}, {1, 3, 2}};
    const NearestTriangle nearest(points, triangles);
    EXPECT_EQ(nearest({0.2, 0.2, 0.5}).triangle, 1u);
    EXPECT_NEAR(nearest({0.2, 0.2, 0.5}).distance, 0.5, 1e-15);
    EXPECT_EQ(nearest({4, 5, 0}).triangle, 2u);
    EXPECT_NEAR(nearest({4, 5, 0}).distance, 5, 1e-15);
    EXPECT_THROW(NearestTriangle(points, std::vector{triangles[0]}), Error);
}

}  // namespace
}  // namespace sherd::test
