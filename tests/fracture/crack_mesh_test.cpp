// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/crack_mesh.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "meshops/components.h"
#include "meshops/error.h"
#include "tests/support/corner_rule.h"
#include "tests/support/mesh_shapes.h"

namespace sherd {
namespace {

using test::CornerRule;
using test::grid;

std::vector<Edge> interior_edges(const Mesh& mesh) {
    std::vector<Edge> edges;
    for (const Edge edge : mesh.edges())
        if (!mesh.is_border(edge)) edges.push_back(edge);
    return edges;
}

Edge edge_between(const Mesh& mesh, int a, int b) {
    return mesh.edge(mesh.halfedge(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b))));
}

std::set<CornerRule::VertexPair> vertex_pairs(const Mesh& mesh, const std::vector<Edge>& edges) {
    std::set<CornerRule::VertexPair> pairs;
    for (const Edge edge : edges)
        pairs.insert(CornerRule::ordered(static_cast<int>(mesh.vertex(edge, 0).idx()),
                                         static_cast<int>(mesh.vertex(edge, 1).idx())));
    return pairs;
}

/// Whether the mesh is the one the corner rule asks for: same faces in the same order, corners joined exactly
/// where the rule joins them, edge states as the rule gives them, and a valid 2-manifold.
void expect_rule(const Mesh& before, const std::vector<Edge>& failed, const CrackMesh& after) {
    CornerRule rule(test::triangles_of(before), vertex_pairs(before, failed));
    const auto faces = test::triangles_of(after.mesh());
    RC_ASSERT(faces.size() == before.number_of_faces());
    std::map<int, int> vertex_of_root;
    for (int f = 0; f < static_cast<int>(faces.size()); ++f)
        for (int i = 0; i < 3; ++i) {
            const auto [found, added] = vertex_of_root.emplace(rule.vertex(f, i), faces[f][i]);
            RC_ASSERT(found->second == faces[f][i]);
        }
    RC_ASSERT(rule.vertex_count() == static_cast<int>(after.mesh().number_of_vertices()));
    RC_ASSERT(after.mesh().number_of_edges() == before.number_of_edges() + rule.open_count());
    for (const Edge edge : failed) {
        const bool open = rule.is_open(static_cast<int>(before.vertex(edge, 0).idx()),
                                       static_cast<int>(before.vertex(edge, 1).idx()));
        RC_ASSERT(after.state(edge) == (open ? EdgeState::boundary : EdgeState::fractured_interior));
    }
    for (const Edge edge : after.mesh().edges())
        if (after.mesh().is_border(edge)) RC_ASSERT(after.state(edge) == EdgeState::boundary);
    RC_ASSERT(after.mesh().is_valid(false));
    RC_ASSERT(CGAL::is_valid_polygon_mesh(after.mesh()));
    for (const Vertex vertex : after.mesh().vertices())  // one fan a vertex: the manifold test
        RC_ASSERT(after.mesh().is_border(vertex) == after.mesh().is_border(after.mesh().halfedge(vertex)));
}

Mesh some_mesh() {
    const int columns = *rc::gen::inRange(3, 6), rows = *rc::gen::inRange(3, 6);
    switch (*rc::gen::inRange(0, 4)) {
        case 0:
            return grid(columns, rows);
        case 1:
            return grid(columns, rows, true);
        case 2:
            return grid(columns, rows, true, true);
        default: {
            Mesh mesh = test::octahedron();
            mesh.join(grid(1, *rc::gen::inRange(1, 4)));
            return mesh;
        }
    }
}

std::vector<Edge> some_edges(const Mesh& mesh) {
    const int percent = *rc::gen::inRange(0, 101);
    std::vector<Edge> chosen;
    for (const Edge edge : interior_edges(mesh))
        if (*rc::gen::inRange(0, 100) < percent) chosen.push_back(edge);
    return chosen;
}

// Any set of edges, all at once.
RC_GTEST_PROP(CrackMesh, BatchFollowsTheCornerRule, ()) {
    const Mesh mesh = some_mesh();
    const std::vector<Edge> failed = some_edges(mesh);
    CrackMesh cracks(mesh);
    cracks.fail(failed);
    expect_rule(mesh, failed, cracks);
}

// The same set, edge by edge in any order: the result may not depend on the order.
RC_GTEST_PROP(CrackMesh, OneByOneInAnyOrderFollowsTheCornerRule, ()) {
    const Mesh mesh = some_mesh();
    std::vector<Edge> failed = some_edges(mesh);
    for (std::size_t i = 1; i < failed.size(); ++i)
        std::swap(failed[i], failed[*rc::gen::inRange<std::size_t>(0, i + 1)]);
    CrackMesh cracks(mesh);
    for (const Edge edge : failed) cracks.fail(std::array{edge});
    expect_rule(mesh, failed, cracks);
}

// What is reported must be what happened: replaying the splits on the faces gives the new faces.
RC_GTEST_PROP(CrackMesh, ChangesAreReportedInFull, ()) {
    const Mesh mesh = some_mesh();
    CrackMesh cracks(mesh);
    const auto before = test::triangles_of(mesh);
    const CrackMesh::Change change = cracks.fail(some_edges(mesh));
    std::map<int, int> origin;
    for (const auto& [vertex, created] : change.opening.vertices) {
        RC_ASSERT(created.idx() == mesh.number_of_vertices() + origin.size());
        origin[static_cast<int>(created.idx())] = static_cast<int>(vertex.idx());
    }
    const auto after = test::triangles_of(cracks.mesh());
    for (std::size_t f = 0; f < after.size(); ++f) {
        auto traced = after[f];
        for (int& vertex : traced)
            if (origin.count(vertex)) vertex = origin[vertex];
        RC_ASSERT(traced == before[f]);
        const bool reported = std::binary_search(change.opening.faces.begin(), change.opening.faces.end(),
                                                 Face(static_cast<unsigned>(f)));
        if (after[f] != before[f]) RC_ASSERT(reported);
    }
}

// B0: a lone edge inside cannot open. B1: a second one from its end opens both. B2: between two boundaries.
TEST(CrackMesh, CountsBoundaryVerticesOfAFailingEdge) {
    CrackMesh cracks(grid(4, 4));
    const Edge lone = edge_between(cracks.mesh(), 6, 7), next = edge_between(cracks.mesh(), 7, 8);
    EXPECT_EQ(cracks.fail(std::array{lone}).boundary_vertices, std::vector{0});
    EXPECT_EQ(cracks.state(lone), EdgeState::fractured_interior);
    EXPECT_EQ(cracks.fail(std::array{next}).boundary_vertices, std::vector{1});
    EXPECT_EQ(cracks.state(lone), EdgeState::boundary);
    EXPECT_EQ(cracks.state(next), EdgeState::boundary);
    CrackMesh strip(grid(3, 1));
    const CrackMesh::Change change = strip.fail(std::array{edge_between(strip.mesh(), 1, 5)});
    EXPECT_EQ(change.boundary_vertices, std::vector{2});
    EXPECT_EQ(change.opening.vertices.size(), 2u);
    EXPECT_EQ(connected_components(strip.mesh()).count, 2);
}

TEST(CrackMesh, RefusesAnEdgeThatCannotFail) {
    CrackMesh cracks(grid(2, 2));
    const Edge rim = edge_between(cracks.mesh(), 0, 1), inside = edge_between(cracks.mesh(), 1, 4);
    EXPECT_THROW(cracks.fail(std::array{rim}), Error);
    EXPECT_THROW(cracks.fail(std::array{inside, inside}), Error);
}

}  // namespace
}  // namespace sherd
