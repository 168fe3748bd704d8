// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

/// Two triangles with values for all vertices, edges and faces, which mostly differ from element to element.
Shell marked_sheet() {
    Shell shell = test::two_triangles(Material{});
    const Index vertices = static_cast<Index>(shell.mass.size());
    for (Index v = 0; v < vertices; ++v) {
        shell.velocity.col(v) = Vector3d(v, -v, 1);
        shell.thickness[v] = 1 + v;
        shell.young[v] = 10 + v;
        shell.footprint[v] = 100 + v;
    }
    shell.fixed = {1, 1, 0, 0};
    shell.script = {3, 3, 0, 0};
    shell.guide = {0, 0, 2, 2};
    shell.support_set = {4, 4, 0, 5};
    shell.vertex_sheet.assign(vertices, 7);
    shell.edge_hinge = {0, -1, -1, -1, -1};
    shell.edge_strength = {5, 6, 7, 8, 9};
    shell.edge_toughness = {15, 16, 17, 18, 19};
    shell.edge_strength_factor = {1, 2, 3, 4, std::numeric_limits<double>::infinity()};
    shell.edge_toughness_factor = {5, 4, 3, 2, 1};
    shell.edge_kept = {0, 0, 0, 1, 0};
    shell.kept = {0, 1, 0, 0};
    shell.face_axis = {Vector3d::UnitX(), Vector3d::UnitY()};
    shell.hinge_edge = {0};
    shell.face_mass = {1, 2};
    shell.face_sheet = {7, 7};
    return shell;
}

// A copy that differs by a bit would change every result of a crack.
TEST(ShellChange, ACopyHasAllThatItsParentHas) {
    Shell shell = marked_sheet();
    follow(shell, {.vertices = {{4, {{1, 1}}}}, .edges = {{5, {{3, 1}}}}, .faces = {{2, {{1, 1}}}}});
    visit_vertices(shell, [](const auto& values, auto... rule) {
        if constexpr (sizeof...(rule) == 0) {
            ASSERT_EQ(values.cols() * values.rows() % 5, 0);
            const auto rows = values.reshaped(values.size() / 5, 5).eval();
            EXPECT_EQ(rows.col(4), rows.col(1));
        } else {
            ASSERT_EQ(values.size(), 5u);
            EXPECT_EQ(values[4], values[1]);
        }
    });
    EXPECT_EQ(shell.edge_strength, (std::vector<double>{5, 6, 7, 8, 9, 8}));
    EXPECT_EQ(shell.edge_toughness.back(), 18);
    EXPECT_EQ(shell.edge_strength_factor.back(), 4);
    EXPECT_EQ(shell.edge_kept.back(), 1);
    EXPECT_EQ(shell.edge_hinge.back(), -1);
    EXPECT_EQ(shell.triangles[2].vertices, shell.triangles[1].vertices);
    EXPECT_EQ(shell.face_sheet, (std::vector<Index>{7, 7, 7}));
}

// A vertex inserted in an edge must lie on it, move with it and be supported like it.
TEST(ShellChange, AVertexBetweenOthersHasTheirMean) {
    Shell shell = marked_sheet();
    const Positions before = shell.position;
    follow(shell, {.vertices = {{4, {{0, 0.25}, {1, 0.75}}}, {5, {{1, 0.5}, {2, 0.5}}}}});
    EXPECT_LT((shell.position.col(4) - (0.25 * before.col(0) + 0.75 * before.col(1))).norm(), 1e-15);
    EXPECT_EQ(shell.velocity.col(4), Vector3d(0.75, -0.75, 1));
    EXPECT_EQ(shell.thickness[4], 1.75);
    EXPECT_EQ(shell.fixed[4], 1);
    EXPECT_EQ(shell.script[4], 3);
    EXPECT_EQ(shell.support_set[4], 4);
    EXPECT_EQ(shell.fixed[5], 0) << "one of its parents is free";
    EXPECT_EQ(shell.guide[5], 0);
    EXPECT_EQ(shell.vertex_sheet[5], 7);
    EXPECT_EQ(shell.kept[4], 0) << "it is a vertex of its own";
}

// A new edge across old faces must be as strong as the edges around it: otherwise it would break first, or
// never.
TEST(ShellChange, AnEdgeAcrossFacesHasTheMeanFactorOfTheFiniteOnesAroundIt) {
    Shell shell = marked_sheet();
    ShellChange change{.edges = {{5, {{1, 1}}}, {6, {}}, {7, {}}}};
    change.crossing = {{0, {0, 1}}, {6, {0, 3, 4}}, {7, {4}}};
    follow(shell, change);
    EXPECT_EQ(shell.edge_strength_factor[0], 1.5) << "of the factors before";
    EXPECT_EQ(shell.edge_strength_factor[5], 2);
    EXPECT_EQ(shell.edge_strength_factor[6], 2.5);
    EXPECT_EQ(shell.edge_strength_factor[7], std::numeric_limits<double>::infinity());
    EXPECT_EQ(shell.edge_kept[6], 0);
}

// Inserted elements may be parents of others in the same change, as when an edge is split and then opened.
TEST(ShellChange, InsertedElementsCanBeParentsInTheSameChange) {
    Shell shell = marked_sheet();
    follow(shell,
           {.vertices = {{4, {{0, 0.5}, {1, 0.5}}}, {5, {{4, 1}}}}, .edges = {{5, {}}, {6, {{5, 1}}}}});
    EXPECT_EQ(shell.position.col(5), shell.position.col(4));
    EXPECT_EQ(shell.edge_strength[5], std::numeric_limits<double>::infinity()) << "it has no parents";
    EXPECT_EQ(shell.edge_strength[6], shell.edge_strength[5]);
    EXPECT_EQ(shell.edge_toughness[5], 0) << "by its strength, which is infinite";
}

// Pressure and wind on a face must act on all of its parts.
TEST(ShellChange, ListsOfFacesGetTheFacesInsertedInTheirs) {
    std::vector<Index> faces{1, 4};
    follow_faces({.faces = {{7, {{4, 1}}}, {8, {{2, 1}}}, {9, {{7, 1}}}, {10, {}}}}, faces);
    EXPECT_EQ(faces, (std::vector<Index>{1, 4, 7, 9}));
}

// Energies keep lists with an entry for each hinge: when a hinge is removed, its entry must be removed at
// the same place as in the shell's list.
TEST(ShellChange, ListsOfHingesFollowTheHingesThatAreRemoved) {
    Shell shell = test::tetrahedron(Material{});
    const auto count = static_cast<Index>(shell.hinges.size());
    for (Index i = 0; i < count; ++i) {
        shell.edge_hinge.push_back(i);
        shell.hinge_edge.push_back(i);
    }
    std::vector<Index> of_hinges = shell.hinge_edge;
    ShellChange change;
    for (const Index edge : {1, 5, 0}) change.removed_hinges.push_back(remove_hinge_of(shell, edge));
    follow_hinges(change, of_hinges);
    EXPECT_EQ(of_hinges, shell.hinge_edge);
    ASSERT_EQ(shell.hinges.size(), 3u);
    for (Index hinge = 0; hinge < 3; ++hinge) EXPECT_EQ(shell.edge_hinge[shell.hinge_edge[hinge]], hinge);
}

}  // namespace
}  // namespace sherd
