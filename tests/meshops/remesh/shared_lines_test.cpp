// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include "meshops/mesh_measures.h"
#include "meshops/remesh/remesh.h"
#include "meshops/remesh/shared_edges.h"
#include "meshops/topology/components.h"

namespace sherd {
namespace {

using Place = std::function<Point(int, int)>;

/// Sheet of columns x rows squares, each of two triangles. closed: whether the last column of vertices is
/// the first one.
Mesh sheet(int columns, int rows, const Place& place, bool closed = false) {
    Mesh mesh;
    std::vector<std::vector<Vertex>> at(columns + 1);
    for (int i = 0; i <= columns; ++i)
        for (int j = 0; j <= rows; ++j)
            at[i].push_back(closed && i == columns ? at[0][j] : mesh.add_vertex(place(i, j)));
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j) {
            mesh.add_face(at[i][j], at[i + 1][j], at[i + 1][j + 1]);
            mesh.add_face(at[i][j], at[i + 1][j + 1], at[i][j + 1]);
        }
    return mesh;
}

Mesh coincident(Mesh one, const Mesh& other) {
    one += other;
    return one;
}

Mesh plate() {
    return sheet(20, 12, [](int i, int j) { return Point(0.01 * i, 0.01 * j, 0); });
}

/// Fin above the sixth row of the plate, from column `from` to column `to`, which continues by `below` rows
/// below the plate.
Mesh fin(int from, int to, int below = 0) {
    return sheet(to - from, 6 + below,
                 [=](int i, int j) { return Point(0.01 * (from + i), 0.01 * 6, 0.01 * (j - below)); });
}

Mesh tube(double radius, int from, int to) {
    return sheet(
        24, to - from,
        [=](int i, int j) {
            const double turn = std::numbers::pi * i / 12;
            return Point(radius * std::cos(turn), radius * std::sin(turn), 0.01 * (from + j));
        },
        true);
}

/// Returns, for each component of the mesh, its points that `is_there` selects.
std::vector<std::set<Point>> points(const Mesh& mesh, const std::function<bool(const Point&)>& is_there) {
    const auto parts = connected_components(mesh);
    std::vector<std::set<Point>> found(parts.count);
    for (const Vertex v : mesh.vertices())
        if (is_there(mesh.point(v)))
            found[parts.of_face[mesh.face(mesh.halfedge(v)) == Mesh::null_face()
                                    ? mesh.face(mesh.opposite(mesh.halfedge(v)))
                                    : mesh.face(mesh.halfedge(v))]]
                .insert(mesh.point(v));
    return found;
}

void expect_one_division(const Mesh& mesh, double edge_length,
                         const std::function<bool(const Point&)>& is_there) {
    const Mesh made = remesh(mesh, {edge_length}).mesh;
    const auto on_line = points(made, is_there);
    ASSERT_EQ(on_line.size(), 2U);
    EXPECT_EQ(on_line[0], on_line[1]) << "edges of " << edge_length;
    EXPECT_GT(on_line[0].size(), 2U);
}

bool is_below_fin(const Point& p) {
    return std::abs(p.y() - 0.06) < 1e-9 && std::abs(p.z()) < 1e-9;
}

// Repair separates sheets at an edge of three or four faces; after remeshing they must still touch only in
// vertices at the same places, which need no exemption from contact. If the edge were divided differently,
// they would touch in faces, and so intersect.
TEST(SharedLines, AreDividedAlikeOnAllSheets) {
    for (const double edge_length : {0.04, 0.023, 0.012, 0.006, 0.0031}) {
        expect_one_division(coincident(plate(), fin(0, 20)), edge_length, is_below_fin);
        expect_one_division(coincident(plate(), fin(0, 20, 6)), edge_length, is_below_fin);
        expect_one_division(coincident(tube(0.05, 0, 6), tube(0.05, 6, 10)), edge_length,
                            [](const Point& p) { return std::abs(p.z() - 0.06) < 1e-9; });
    }
}

// The shared line ends within the plate, where a border of the fin turns upwards.
TEST(SharedLines, EndWhereSheetsPart) {
    for (const double edge_length : {0.023, 0.012, 0.006})
        expect_one_division(coincident(plate(), fin(4, 15)), edge_length, [](const Point& p) {
            return is_below_fin(p) && p.x() > 0.04 - 1e-9 && p.x() < 0.15 + 1e-9;
        });
}

// Two layers in one place share all of their edges: if all these counted as shared lines, nothing could be
// remeshed.
TEST(SharedLines, AreNotThoseOfDoubledSheets) {
    const SharedEdges doubled = shared_edges(coincident(plate(), plate()));
    EXPECT_EQ(std::ranges::count(doubled.is_shared, 1), 0);
    EXPECT_TRUE(doubled.coincident.empty());
    const SharedEdges standing = shared_edges(coincident(plate(), fin(0, 20)));
    EXPECT_EQ(std::ranges::count(standing.is_shared, 1), 40);
    EXPECT_EQ(standing.coincident.size(), 21U);
}

}  // namespace
}  // namespace sherd
