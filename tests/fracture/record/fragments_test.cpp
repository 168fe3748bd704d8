// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/fragments.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "fracture/mesh/crack_mesh.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

std::vector<double> areas_of(const Mesh& mesh) {
    std::vector<double> areas;
    for (const Face face : mesh.faces()) areas.push_back(face_area(mesh, face));
    return areas;
}

/// Edges of a grid of `columns` by `rows` squares on its line number `x` across the rows.
std::vector<Edge> column_edges(const Mesh& mesh, unsigned columns, unsigned rows, unsigned x) {
    std::vector<Edge> edges;
    for (unsigned y = 0; y < rows; ++y)
        edges.push_back(
            mesh.edge(mesh.halfedge(Vertex(y * (columns + 1) + x), Vertex((y + 1) * (columns + 1) + x))));
    return edges;
}

// The larger part must keep its number and the other part get a new one, also when the other part splits
// again.
TEST(Fragments, KeepTheirNumbersWhileOthersSplit) {
    const Mesh whole = test::grid(10, 2);
    const std::vector<double> areas = areas_of(whole);
    CrackMesh cracks(whole);
    Fragments fragments(whole, areas);
    EXPECT_EQ(fragments.count(), 1);
    EXPECT_EQ(fragments.parents()[0], -1);

    cracks.fail(column_edges(whole, 10, 2, 4));  // splits 4 columns off on the left
    fragments.update(cracks.mesh(), areas);
    cracks.fail(column_edges(whole, 10, 2, 3));  // splits a column off these four
    fragments.update(cracks.mesh(), areas);
    ASSERT_EQ(fragments.count(), 3);
    EXPECT_EQ(fragments.parents()[1], 0);
    EXPECT_EQ(fragments.parents()[2], 1);
    for (const Face face : whole.faces()) {
        double x = 0;
        for (const Vertex v : whole.vertices_around_face(whole.halfedge(face))) x += whole.point(v).x() / 3;
        const double column = x / whole.point(Vertex(1)).x();
        EXPECT_EQ(fragments.of_face()[face], column > 4 ? 0 : column > 3 ? 2 : 1);
    }
}

// Whatever edges fail, and in whatever order: each component must have a number of its own, separated faces
// must never share a number again, each new number must have the earlier number of its faces as parent, and
// the largest part must keep its number.
RC_GTEST_PROP(Fragments, AreComponentsWithAncestors, ()) {
    const Mesh whole = test::grid(*rc::gen::inRange(2, 7), *rc::gen::inRange(1, 5));
    const std::vector<double> areas = areas_of(whole);
    CrackMesh cracks(whole);
    Fragments fragments(whole, areas);
    for (int batch = 0; batch < 4; ++batch) {
        std::vector<Edge> failing;
        for (const Edge edge : whole.edges())
            if (cracks.state(edge) == EdgeState::interior && *rc::gen::inRange(0, 3) == 0)
                failing.push_back(edge);
        const std::vector<Index> before(fragments.of_face().begin(), fragments.of_face().end());
        cracks.fail(failing);
        fragments.update(cracks.mesh(), areas);

        const Components pieces = connected_components(cracks.mesh());
        RC_ASSERT(fragments.count() == pieces.count);
        std::map<Index, Index> piece_of;
        std::map<Index, double> area_of;
        for (const Face face : whole.faces()) {
            const Index number = fragments.of_face()[face];
            RC_ASSERT(piece_of.emplace(number, pieces.of_face[face]).first->second == pieces.of_face[face]);
            area_of[number] += areas[face];
            const bool is_new = number >= *std::max_element(before.begin(), before.end()) + 1;
            RC_ASSERT((is_new ? fragments.parents()[number] : number) == before[face]);
        }
        for (const auto& [number, area] : area_of) {
            const bool is_new = number >= *std::max_element(before.begin(), before.end()) + 1;
            if (is_new) RC_ASSERT(area <= area_of[fragments.parents()[number]] * (1 + 1e-12));
        }
    }
}

}  // namespace
}  // namespace sherd
