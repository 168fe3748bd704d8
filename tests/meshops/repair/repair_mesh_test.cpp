// SPDX-License-Identifier: GPL-3.0-or-later
// Repairs of read_mesh(), which must change nothing beyond the permitted faults.
#include <gtest/gtest.h>

#include "meshops/attributes.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_reading.h"

namespace sherd {
namespace {

using RepairMesh = test::MeshReading;
using test::area, test::triangles, test::square, test::repair, test::Triangles;

// A dropped triangle must leave no slit: a plate would break there by itself.
TEST_F(RepairMesh, LeavesNoSlitWhereATriangleHadNoArea) {
    const std::string flat = square + "v 0.5 0.5 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5 0.5\n";
    const Mesh divided =
        read("a.obj", flat + "f 1/1 2/2 5/5\nf 2/2 3/3 5/5\nf 5/5 3/3 1/1\nf 1/1 3/3 4/4\n", repair);
    EXPECT_EQ(triangles(divided), (Triangles{{0, 1, 4}, {1, 2, 4}, {0, 4, 3}, {4, 2, 3}}));
    EXPECT_NEAR(area(divided), 1, 1e-15);
    EXPECT_EQ(measure(divided).boundary_loops, 1);
    const auto texture = find_property(divided, attribute::texture).first;
    EXPECT_EQ(texture[Face(2)][1], Eigen::Vector2d(0.5, 0.5));
    // Two corners at one place, as at the pole of a sphere of quads: the faces around become one fan.
    const Mesh pole = read("b.obj",
                           "v 0 0 1\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\n"
                           "f 1 3 4\nf 1 4 2\nf 2 4 5\n",
                           repair);
    EXPECT_EQ(triangles(pole), (Triangles{{0, 2, 3}, {0, 3, 4}}));
    EXPECT_EQ(connected_components(pole).count, 1);
}

TEST_F(RepairMesh, TurnsClosedPartsOutward) {
    const std::string points = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n";
    const std::string inward = "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n",
                      outward = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const Triangles expected = triangles(read("a.obj", points + outward, repair));
    EXPECT_TRUE(warnings.empty());
    EXPECT_EQ(triangles(read("b.obj", points + inward, repair)), expected);
    expect_warning("4 faces were turned over, of closed parts that were inside out");
    // Normals of a cavity point into it.
    const std::string cavity = "v 1 1 1\nv 2 1 1\nv 1 2 1\nv 1 1 2\nf 5 6 7\nf 5 8 6\nf 6 8 7\nf 7 8 5\n";
    const Mesh hollow = read("c.obj", points + outward + cavity, repair);
    EXPECT_EQ(triangles(hollow)[4], (std::vector<unsigned>{4, 5, 6}));
    EXPECT_TRUE(warnings.empty());
}

// A soup of triangles has no sheet to bend; a mesh with a seam may have an opened crack there.
TEST_F(RepairMesh, JoinsSoupsAndNamesSeams) {
    const std::string soup = square + "v 0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n";
    EXPECT_EQ(connected_components(read("a.obj", soup, repair)).count, 1);
    expect_warning("2 vertices were joined with another at the same place, since no two faces shared one");
    const std::string seam = square + "v 0 0 0\nv 1 1 0\nv 0 2 0\nf 1 2 3\nf 5 6 4\nf 4 6 7\n";
    EXPECT_EQ(connected_components(read("b.obj", seam, repair)).count, 2);
    expect_warning(
        "2 edges lie on each other without being joined, as along a crack (the first: vertices 0 and 2");
    EXPECT_EQ(warnings.size(), 1U);
}

TEST_F(RepairMesh, MendsNothingWhereNothingMayBe) {
    const ReadMeshOptions nothing{.repair = Repair::none};
    expect_failure("a.obj", square + "v 9 9 9\nf 1 2 3\nf 1 3 4\n", "no face uses 1 of the vertices; `repair",
                   nothing);
    expect_failure("a.obj", square + "f 1 2 3\nf 1 4 3\n", "does not point the same way", nothing);
    expect_failure("a.obj", square + "v 2 1 0\nv 2 2 0\nf 1 2 3\nf 3 5 6\nv 9 9 9\nf 1 3 4\nf 7 1 2\n",
                   "meet at vertex 2", nothing);
    expect_failure("a.obj", square + "v 0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n",
                   "`join = true` on the mesh joins them", nothing);
    expect_failure("a.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n",
                   "points into the closed surface", nothing);
    EXPECT_EQ(read("b.obj", square + "f 1 2 3\nf 1 3 4\n", nothing).number_of_faces(), 2U);
}

// Exporters write faces twice, for two sides, or as polygons and as their triangles: a repeated sheet would
// be separated at every edge.
TEST_F(RepairMesh, DropsFacesThatAreThereTwiceHoweverTheyBegin) {
    const std::string points = square + "v 2 0 0\nv 2 1 0\n", quads = "f 1 2 3 4\nf 2 5 6 3\n";
    for (const std::string again : {"f 3 4 1 2\nf 6 3 2 5\n", "f 4 3 2 1\nf 3 6 5 2\n",
                                    "f 1 2 3\nf 1 3 4\nf 2 5 3\nf 5 6 3\n", "f 3 2 1\nf 4 3 1\n"}) {
        for (const std::string& text : {quads + again, again + quads}) {
            const Mesh mesh = read("a.obj", points + text, repair);
            EXPECT_EQ(mesh.number_of_faces(), 4U) << text;
            EXPECT_EQ(connected_components(mesh).count, 1) << text;
            EXPECT_NEAR(area(mesh), 2, 1e-15) << text;
            expect_warning("dropped as repeated (the first: ");
            expect_failure("a.obj", points + text, "drops repeated");
        }
    }
    // A pentagon again in parts of three and four corners.
    const std::string pentagon = "v 0 0 0\nv 2 0 0\nv 3 2 0\nv 1 3 0\nv -1 2 0\nf 1 2 3 4 5\n";
    EXPECT_EQ(read("b.obj", pentagon + "f 1 2 3\nf 1 3 4 5\n", repair).number_of_faces(), 3U);
    const std::string bent = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nv 2 0 0\nv 2 1 0.2\n";
    // A tetrahedron, however flat, is a body; a face between two others is a wall.
    EXPECT_EQ(read("e.obj", bent + "f 1 2 3\nf 1 3 4\nf 4 3 2\nf 4 2 1\n", repair).number_of_faces(), 4U);
    EXPECT_EQ(read("f.obj", square + "v 0 0 1\nf 1 2 3 4\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n", repair)
                  .number_of_faces(),
              6U);
}

TEST_F(RepairMesh, DropsWhatBoundsNothing) {
    const Mesh mesh =
        read("a.obj", square + "vt 0 0\nf 1/1 2/1\nf 1/1 2/1 3/1\nf 4\nf 1/1 3/1 4/1\n", repair);
    EXPECT_EQ(triangles(mesh), (Triangles{{0, 1, 2}, {0, 2, 3}}));
    expect_warning("2 faces were dropped for fewer than three corners (the first: ");
    EXPECT_EQ(warnings.size(), 1U);
    expect_failure("a.obj", square + "f 1 2\n", "no faces left", repair);
    // Depth cameras write unseen points as NaN.
    const std::string unseen = square + "v nan nan nan\nv nan inf 0\nv 0 0 0\nf 1 2 3\nf 7 3 4\n";
    EXPECT_EQ(read("b.obj", unseen, repair).number_of_vertices(), 6U);
    expect_warning("2 vertices were dropped that no face uses");
    EXPECT_EQ(read("b.obj", unseen, {.join_duplicate_points = true}).number_of_vertices(), 4U);
}

// When a fin is separated from a plate, half of the plate must not go with it.
TEST_F(RepairMesh, SheetsGoStraightOnWhereTheyMeet) {
    const std::string cross =
        "v 0 0 0\nv 0 1 0\nv 1 0.5 0\nv 0 0.5 1\nv -1 0.5 0\nv 0 0.5 -1\n"
        "f 2 1 4\nf 1 2 3\nf 2 1 5\nf 1 2 6\n";
    const Mesh mesh = read("a.obj", cross, repair);
    const Components found = connected_components(mesh);
    EXPECT_EQ(found.count, 2);
    EXPECT_EQ(found.of_face[0], found.of_face[3]);
    EXPECT_EQ(found.of_face[1], found.of_face[2]);
    // Three leaves at equal angles: none of them continues in another.
    const std::string star =
        "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -0.5 0.8660254037844386 0\nv -0.5 -0.8660254037844386 0\n"
        "f 1 2 3\nf 1 2 4\nf 1 2 5\n";
    EXPECT_EQ(connected_components(read("b.obj", star, repair)).count, 3);
}

}  // namespace
}  // namespace sherd
