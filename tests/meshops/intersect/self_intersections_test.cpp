// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/self_intersections.h"

#include <gtest/gtest.h>

#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

// A missed pair would hide sheets that pass through each other from all tests that use this function.
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

// Large meshes are searched in strips, at whose borders nothing may be missed or found twice.
TEST(SelfIntersections, FindsThoseOfALargeMesh) {
    const int columns = 50, rows = 1000;
    Mesh mesh = test::grid(columns, rows);
    std::vector<std::array<Face, 2>> expected;
    for (int row = 3; row < rows; row += 7) {
        // Through the first triangle of a square, off its diagonal.
        const Point at(20.6, row + 0.3, 0);
        const Vertex a = mesh.add_vertex(Point(at.x(), at.y(), -1)),
                     b = mesh.add_vertex(Point(at.x() + 0.1, at.y(), -1)),
                     c = mesh.add_vertex(Point(at.x(), at.y() + 0.1, 1));
        const Face pierced(static_cast<Mesh::size_type>(2 * (columns * row + 20)));
        expected.push_back({pierced, mesh.add_face(a, b, c)});
    }
    EXPECT_EQ(self_intersections(mesh), expected);
}

}  // namespace
}  // namespace sherd
