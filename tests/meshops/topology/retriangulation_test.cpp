// SPDX-License-Identifier: GPL-3.0-or-later
// With errors in Retriangulation, mass, momentum or other data of a sheet would be lost or added where
// triangles change.
#include "meshops/topology/retriangulation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meshops/mesh_measures.h"
#include "tests/support/mesh/drawn_sheet.h"
#include "tests/support/mesh/sheet_oracle.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

Halfedge between(const Mesh& mesh, unsigned a, unsigned b) {
    return mesh.halfedge(Vertex(a), Vertex(b));
}

TEST(Retriangulation, ASplitEdgePassesOnItsDataAndItsFaces) {
    Mesh mesh = grid(2, 2);  // vertex (i, j) has the number 3 j + i
    const TriangleSheet old = arrays_of(mesh);
    const Edge split = mesh.edge(between(mesh, 4, 1));
    Retriangulation edits(mesh);
    const Vertex created = edits.split_edge(between(mesh, 4, 1), 0.25);
    const TopologyChange change = edits.finish();
    EXPECT_EQ(position(mesh, created), Vector3d(1, 0.75, 0));
    ASSERT_EQ(change.vertices.size(), 1u);
    EXPECT_EQ(change.vertices[0].parents[0].element, Vertex(4u));
    EXPECT_EQ(change.vertices[0].parents[0].weight, 0.75);
    ASSERT_EQ(change.edges.size(), 3u) << "the other half, and one in each face";
    EXPECT_EQ(change.edges[0].parent(), split);
    EXPECT_TRUE(change.edges[1].parents.empty() && change.edges[2].parents.empty());
    EXPECT_EQ(change.faces.size(), 2u);
    EXPECT_TRUE(change.moved.empty() && change.flipped.empty() && change.opened.empty());
    expect_same_sheet(old, mesh, change, true);
}

TEST(Retriangulation, ASplitOfTheBoundaryStaysOnIt) {
    Mesh mesh = grid(1, 1);
    const TriangleSheet old = arrays_of(mesh);
    Retriangulation edits(mesh);
    EXPECT_TRUE(mesh.is_border(edits.split_edge(between(mesh, 0, 1), 0.5)));
    EXPECT_TRUE(mesh.is_border(edits.split_edge(between(mesh, 2, 0), 0.5)));
    expect_same_sheet(old, mesh, edits.finish(), true);
}

TEST(Retriangulation, AFlippedEdgeIsNamedAndBothFacesGetHalfOfEach) {
    Mesh mesh = grid(1, 1);
    const TriangleSheet old = arrays_of(mesh);
    const Edge diagonal = mesh.edge(between(mesh, 0, 3));
    Retriangulation edits(mesh);
    EXPECT_FALSE(edits.can_flip(mesh.edge(between(mesh, 0, 1)))) << "on the boundary";
    ASSERT_TRUE(edits.can_flip(diagonal));
    edits.flip(diagonal);
    const TopologyChange change = edits.finish();
    EXPECT_EQ(change.flipped, std::vector{diagonal});
    for (const auto& [face, shares] : change.reshaped)
        for (const auto& [old_face, share] : shares) EXPECT_NEAR(share, 0.5, 1e-15);
    expect_same_sheet(old, mesh, change, true);
}

TEST(Retriangulation, AMovedVertexHasThePlaceInOneOldFace) {
    Mesh mesh = grid(2, 2);
    const TriangleSheet old = arrays_of(mesh);
    const Face face = mesh.face(between(mesh, 4, 5));
    Retriangulation edits(mesh);
    edits.move(Vertex(4u), nearest_point(mesh, face, {1.4, 1.1, 0}));
    const TopologyChange change = edits.finish();
    EXPECT_LT((position(mesh, Vertex(4u)) - Vector3d(1.4, 1.1, 0)).norm(), 1e-15);
    ASSERT_EQ(change.moved.size(), 1u);
    EXPECT_EQ(change.moved[0].parents.size(), 3u);
    EXPECT_EQ(change.changed.size(), 6u);
    expect_same_sheet(old, mesh, change, true);
}

// The edges of a tetrahedron cannot be flipped: the edges that would result exist already.
TEST(Retriangulation, NoSecondEdgeBetweenTwoVertices) {
    Mesh mesh;
    const auto a = mesh.add_vertex({0, 0, 0}), b = mesh.add_vertex({1, 0, 0});
    const auto c = mesh.add_vertex({0, 1, 0}), d = mesh.add_vertex({0.3, 0.3, 0.1});
    for (const auto& face :
         {std::array{a, c, b}, std::array{a, b, d}, std::array{b, c, d}, std::array{c, a, d}})
        mesh.add_face(face);
    const Retriangulation edits(mesh);
    for (const Edge edge : mesh.edges()) EXPECT_FALSE(edits.can_flip(edge));
}

/// Makes one random split or flip.
void edit_somewhere(const Mesh& mesh, Retriangulation& edits, Random& random) {
    const Face face(random.below(mesh.number_of_faces()));
    const Halfedge h = mesh.halfedge(face);
    const Vector3d weights = (random.matrix<Vector3d>(1).cwiseAbs() + Vector3d::Constant(0.1)).normalized();
    switch (random.below(4)) {
        case 0:
            edits.split_edge(h, random.uniform(0.2, 0.8));
            break;
        case 1:
            edits.split_face(face, weights / weights.sum());
            break;
        default:
            if (edits.can_flip(mesh.edge(h))) edits.flip(mesh.edge(h));
    }
}

// Several changes follow on each other: vertices may then have more parents, but everything else must hold.
RC_GTEST_PROP(Retriangulation, RandomSplitsAndFlipsKeepTheSheet, ()) {
    const unsigned shape = *rc::gen::inRange(0u, sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    Mesh mesh = drawn_sheet(shape, seed);
    Random random(seed + 1);
    const TriangleSheet old = arrays_of(mesh);
    Retriangulation edits(mesh);
    for (unsigned i = random.below(12) + 1; i > 0; --i) edit_somewhere(mesh, edits, random);
    const TopologyChange change = edits.finish();
    expect_manifold(old, mesh, arrays_of(mesh));
    expect_areas(old, arrays_of(mesh), change, is_flat_sheet(shape));
    RC_ASSERT(!testing::Test::HasFailure());
}

/// Whether a face around a vertex would be folded over if the vertex were at `target`.
bool folds(const Mesh& mesh, Vertex vertex, const Vector3d& target) {
    for (const Face face : mesh.faces_around_target(mesh.halfedge(vertex))) {
        const std::array<Vertex, 3> corners = face_corners(mesh, face);
        std::array<Vector3d, 3> points = face_points(mesh, face);
        const Vector3d before = triangle_normal(points);
        points[std::ranges::find(corners, vertex) - corners.begin()] = target;
        if (triangle_normal(points).dot(before) <= 0) return true;
    }
    return false;
}

// Moves that fold faces over are left out, since move() does not allow them.
RC_GTEST_PROP(Retriangulation, RandomMovesKeepTheSheet, ()) {
    const unsigned shape = *rc::gen::inRange(0u, sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    Mesh mesh = drawn_sheet(shape, seed);
    Random random(seed + 1);
    const TriangleSheet old = arrays_of(mesh);
    const Halfedge h = mesh.halfedge(Face(random.below(mesh.number_of_faces())));
    const Vertex vertex = mesh.target(h);
    if (mesh.is_border(vertex)) return;
    const Vector3d target =
        position(mesh, vertex) +
        random.uniform(0, 0.2) * (position(mesh, mesh.source(h)) - position(mesh, vertex)) +
        random.uniform(0, 0.1) * (position(mesh, mesh.target(mesh.next(h))) - position(mesh, vertex));
    const SurfacePoint place = nearest_point(mesh, mesh.face(h), target);
    if (folds(mesh, vertex, position(mesh, place))) return;
    Retriangulation edits(mesh);
    edits.move(vertex, place);
    expect_same_sheet(old, mesh, edits.finish(), is_flat_sheet(shape));
    RC_ASSERT(!testing::Test::HasFailure());
}

}  // namespace
}  // namespace sherd::test
