// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/surface_crossings.h"

#include <gtest/gtest.h>

#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

// A missed face would hide an obstacle that passes through a sheet from all tests that use this function.
TEST(SurfaceCrossings, FindsTheFacesThatASurfacePassesThrough) {
    const Mesh mesh = test::grid(2, 2);
    const auto crossed_by = [&](double x, double y, double top) {
        const std::vector<Eigen::Vector3d> needle{{x, y, -1}, {x + 0.01, y, -1}, {x, y + 0.01, top}};
        const std::vector<std::array<std::int32_t, 3>> triangles{{0, 1, 2}, {0, 0, 1}};
        return surface_crossings(mesh, needle, triangles);
    };
    EXPECT_EQ(crossed_by(0.3, 0.2, 1).size(), 1u);
    EXPECT_EQ(crossed_by(0.3, 0.2, 0).size(), 1u) << "touches";
    EXPECT_TRUE(crossed_by(0.3, 0.2, -1e-12).empty()) << "ends below";
    EXPECT_TRUE(crossed_by(5, 0.2, 1).empty()) << "beside it";
}

}  // namespace
}  // namespace sherd
