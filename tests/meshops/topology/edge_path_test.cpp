// SPDX-License-Identifier: GPL-3.0-or-later
// With errors in edge_path(), a pre-scored line would have gaps or lie elsewhere than drawn.
#include "meshops/topology/edge_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

std::vector<Edge> path_of(const Mesh& mesh, const std::vector<Vector3d>& line) {
    return edge_path(mesh, line);
}

double length_of(const Mesh& mesh, const std::vector<Edge>& path) {
    double length = 0;
    for (const Edge e : path)
        length += (position(mesh, mesh.vertex(e, 1)) - position(mesh, mesh.vertex(e, 0))).norm();
    return length;
}

/// Numbers of the vertices at which an odd number of the path's edges ends: for a simple path, its two ends.
std::set<std::uint32_t> ends_of(const Mesh& mesh, const std::vector<Edge>& path) {
    std::set<std::uint32_t> odd;
    for (const Edge e : path)
        for (const int side : {0, 1}) {
            const std::uint32_t v = mesh.vertex(e, side).idx();
            if (!odd.erase(v)) odd.insert(v);
        }
    return odd;
}

std::string message_of(const Mesh& mesh, const std::vector<Vector3d>& line) {
    return message_thrown_by([&] { edge_path(mesh, line); });
}

TEST(EdgePath, FollowsMeshLinesExactly) {
    const Mesh mesh = grid(6, 4);  // vertex (i, j) has the number 7 j + i
    const std::vector<Edge> path = path_of(mesh, {{1.2, 0.9, 0}, {4.1, 1.1, 0}, {4, 3.4, 0.1}});
    ASSERT_EQ(path.size(), 5u) << "three edges along the row, two up the column";
    EXPECT_EQ(length_of(mesh, path), 5);
    EXPECT_EQ(ends_of(mesh, path), (std::set<std::uint32_t>{7 + 1, 3 * 7 + 4}));
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_EQ(ends_of(mesh, {path[i - 1], path[i]}).size(), 2u) << "each edge goes on from the last";
}

// Many paths lead from one point of the rim to the opposite one; the path along the line is needed.
TEST(EdgePath, KeepsCloseToTheLineOnAnyMesh) {
    for (const double degrees : {0.0, 17.0, 30.0, 45.0, 71.0, 90.0, 133.0}) {
        const Mesh mesh = generate_disc(1, {.edge_length = 0.05});
        const double angle = degrees * std::acos(-1.0) / 180;
        const Vector3d end(std::cos(angle), std::sin(angle), 0), normal(-end.y(), end.x(), 0);
        const std::vector<Edge> path = path_of(mesh, {-end, end});
        for (const Edge e : path)
            for (const int side : {0, 1})
                EXPECT_LT(std::abs(normal.dot(position(mesh, mesh.vertex(e, side)))), 0.05) << degrees;
        EXPECT_LT(length_of(mesh, path), 2 * 1.25) << degrees;
        const std::set<std::uint32_t> ends = ends_of(mesh, path);
        ASSERT_EQ(ends.size(), 2u);
        for (const std::uint32_t v : ends) EXPECT_TRUE(mesh.is_border(Vertex(v))) << "from rim to rim";
    }
}

TEST(EdgePath, ACoarseLineFollowsACurvedSurface) {
    const Mesh mesh = generate_sphere(1, {.edge_length = 0.1});
    const std::vector<Edge> path = path_of(mesh, {{1, 0, 0}, {0, 1, 0}});
    EXPECT_EQ(ends_of(mesh, path).size(), 2u);
    EXPECT_LT(length_of(mesh, path), 1.25 * std::acos(0.0)) << "the quarter of a great circle";
    for (const Edge e : path) EXPECT_LT(std::abs(position(mesh, mesh.vertex(e, 0)).z()), 0.15);
}

TEST(EdgePath, EdgesComeOnceThoughTheLineGoesBack) {
    const Mesh mesh = grid(6, 4);
    const auto path = path_of(mesh, {{0, 1, 0}, {4, 1, 0}, {2, 1, 0}, {2, 3, 0}});
    EXPECT_EQ(path.size(), 6u);
    EXPECT_EQ(std::set<Edge>(path.begin(), path.end()).size(), 6u);
    EXPECT_EQ(path_of(mesh, {{0, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}).size(), 4u) << "closed";
}

TEST(EdgePath, RefusesWhatIsNoPath) {
    Mesh mesh = grid(4, 2);
    EXPECT_NE(message_of(mesh, {{0, 0, 0}, {2, 0, 3}}).find("point 1 of the line"), std::string::npos);
    EXPECT_NE(message_of(mesh, {{0, 0, 0}, {0.1, 0.1, 0}}).find("one vertex only"), std::string::npos);
    std::vector<Vertex> corners;
    for (const Point& p : {Point(10, 0, 0), Point(11, 0, 0), Point(10, 1, 0)})
        corners.push_back(mesh.add_vertex(p));
    mesh.add_face(corners);
    EXPECT_NE(message_of(mesh, {{0, 0, 0}, {10, 0, 0}}).find("points 0 and 1"), std::string::npos);
}

}  // namespace
}  // namespace sherd::test
