// SPDX-License-Identifier: GPL-3.0-or-later
// If axes were read wrongly, the axes in a mesh file would belong to wrong faces.
#include <gtest/gtest.h>

#include "meshops/attributes.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/mesh/ply_square.h"
#include "tests/support/program/replaced.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

std::vector<Eigen::Vector3d> axes_in(const std::string& text, bool repair = false) {
    const TemporaryDirectory directory;
    std::vector<std::string> warnings;
    const Mesh mesh =
        read_mesh(directory.write("a.ply", text), {.repair = repair ? Repair::all : Repair::least}, warnings);
    const auto [axis, exists] = find_property(mesh, attribute::axis);
    std::vector<Eigen::Vector3d> found;
    if (exists)
        for (const Face face : mesh.faces()) found.push_back(axis[face]);
    return found;
}

TEST(ReadAxis, FacePropertiesBecomeTheAxesOfTheFaces) {
    const auto axes = axes_in(ply_square("1 2 3", "-4 5 0.5"));
    ASSERT_EQ(axes.size(), 2u);
    EXPECT_EQ(axes[0], Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(axes[1], Eigen::Vector3d(-4, 5, 0.5));
}

TEST(ReadAxis, TrianglesOfAPolygonHaveItsAxisAndDroppedOnesTakeTheirsAlong) {
    const std::string quad = replaced(ply_square("1 2 3", "9 9 9"), "3 0 1 2", "4 0 1 2 3");
    // The second triangle is reduced to zero area.
    const auto axes = axes_in(replaced(quad, "3 0 2 3", "3 2 2 3"), true);
    ASSERT_EQ(axes.size(), 2u);
    for (const Eigen::Vector3d& axis : axes) EXPECT_EQ(axis, Eigen::Vector3d(1, 2, 3));
}

TEST(ReadAxis, WithoutAllThreePropertiesThereIsNone) {
    EXPECT_TRUE(axes_in(replaced(ply_square("1 2 3", "1 2 3"), "axis_y", "axis")).empty());
}

}  // namespace
}  // namespace sherd::test
