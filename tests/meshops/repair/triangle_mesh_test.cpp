// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays come from other programs: faults must be reported by number, and valid elements keep their numbers.
#include "meshops/repair/triangle_mesh.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

using Triangles = std::vector<std::array<std::int32_t, 3>>;

/// Square of two triangles with vertices 0 to 3, and three additional vertices outside.
const std::vector<Eigen::Vector3d> corner_points{{0, 0, 0}, {1, 0, 0},  {1, 1, 0}, {0, 1, 0},
                                                 {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};

std::string message_of(const Triangles& triangles, std::size_t used,
                       std::vector<Eigen::Vector3d> positions = corner_points) {
    positions.resize(used);
    return message_thrown_by([&] { triangle_mesh(positions, triangles); });
}

TEST(TriangleMesh, KeepsNumbersAndPlaces) {
    const Triangles square{{2, 3, 0}, {0, 1, 2}};
    const Mesh mesh = triangle_mesh(std::span(corner_points).first(4), square);
    ASSERT_EQ(mesh.number_of_vertices(), 4u);
    ASSERT_EQ(mesh.number_of_faces(), 2u);
    EXPECT_EQ(mesh.number_of_edges(), 5u);
    for (std::int32_t v = 0; v < 4; ++v) EXPECT_EQ(position(mesh, Vertex(v)), corner_points[v]);
    for (std::int32_t f = 0; f < 2; ++f)
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(Face(f))))
            EXPECT_NE(std::ranges::find(square[f], static_cast<std::int32_t>(v)), square[f].end());
    EXPECT_NEAR(measure(mesh).area, 1, 1e-15);
}

TEST(TriangleMesh, NamesWhatIsWrong) {
    EXPECT_EQ(message_of({}, 4), "a mesh needs at least one triangle");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 4}}, 4),
              "face 1: vertex 4 does not exist; there are 4, numbered from 0");
    EXPECT_EQ(message_of({{0, 1, -1}}, 4), "face 0: vertex -1 does not exist; there are 4, numbered from 0");
    EXPECT_EQ(message_of({{0, 1, 2}}, 4), "vertex 3: no face uses it; leave it out");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {3, 0, 3}}, 4),
              "face 2: its vertices 3, 0 and 3 enclose no area");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {2, 3, 0}}, 4),
              "face 2: an earlier face has the same vertices 2, 3 and 0");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {0, 2, 4}}, 5),
              "face 2: is the third face at the edge of vertices 0 and 2, beside faces 0 and 1; a sheet has "
              "two at most");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {0, 5, 6}, {0, 6, 4}}, 7),
              "vertex 0: faces meet there that no edge joins; give each side a vertex of its own");
    EXPECT_EQ(message_of({{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {5, 0, 6}}, 7).find("vertex 4: no face"), 0u);
    EXPECT_EQ(
        message_of({{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {3, 0, 4}}, 5),
        "face 3: its normal is opposite to those of its neighbours; swap two of its vertices 3, 0 and 4");
    std::vector<Eigen::Vector3d> broken = corner_points;
    broken[1].y() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of({{0, 1, 2}}, 3, broken), "vertex 1: has a coordinate that is NaN or infinite");
}

TEST(TriangleMesh, ABandWithOneSideIsRefused) {
    // Five triangles in a ring that is twisted once.
    std::vector<Eigen::Vector3d> ring;
    for (int i = 0; i < 5; ++i) ring.emplace_back(std::cos(1.2 * i), std::sin(1.2 * i), 0.1 * i * i);
    const Triangles band{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 0, 4}, {4, 0, 1}};
    EXPECT_NE(message_of(band, 5, ring).find("belongs to a surface that has only one side"),
              std::string::npos)
        << message_of(band, 5, ring);
}

}  // namespace
}  // namespace sherd::test
