// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/mesh/crack_mesh.h"

#include <gtest/gtest.h>

#include <array>

#include "meshops/error.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

using test::grid;

Edge edge_between(const Mesh& mesh, int a, int b) {
    return mesh.edge(mesh.halfedge(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b))));
}

// Number of an edge's ends on other failed or boundary edges (B0, B1, B2 in the paper): with 0, a lone inner
// edge cannot open; with 1, an edge from its end opens both; with 2, an edge between two boundaries opens
// and divides the sheet.
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
    EXPECT_EQ(change.topology.vertices.size(), 2u);
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
