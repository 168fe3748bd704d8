// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/self_intersections.h"

#include <gtest/gtest.h>

#include "tests/support/mesh_shapes.h"

namespace sherd {
namespace {

// Missed, two sheets would pass through each other unseen in every proof that rests on this.
TEST(SelfIntersections, FindsCrossingFacesAndNoNeighbours) {
    Mesh mesh = test::grid(2, 2);
    EXPECT_TRUE(self_intersections(mesh).empty()) << "faces that share vertices and edges";
    const Vertex a = mesh.add_vertex(Point(0.3, 0.2, -1)), b = mesh.add_vertex(Point(0.4, 0.2, -1)),
                 c = mesh.add_vertex(Point(0.35, 0.25, 1));
    const Face needle = mesh.add_face(a, b, c);
    const auto found = self_intersections(mesh);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0][1], needle);
}

}  // namespace
}  // namespace sherd
