// SPDX-License-Identifier: GPL-3.0-or-later
// Seams that are nearly closed, and vertices that lie on edges without dividing them, must be reported, or
// joined on request.
#include <gtest/gtest.h>

#include "meshops/attributes.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/mesh_reading.h"

namespace sherd {
namespace {

using OpenSeams = test::MeshReading;
using test::area, test::repair;

ReadMeshOptions joining(double distance) {
    return {.repair = Repair::all, .join_distance = distance};
}

/// Two quads side by side; the second begins at x = 1 + `gap`, where `gap` is given as its decimals.
std::string two_quads(const std::string& gap) {
    return test::square + "v 1" + gap + " 0 0\nv 2 0 0\nv 2 1 0\nv 1" + gap + " 1 0\nf 1 2 3 4\nf 5 6 7 8\n";
}

// A sheet in separate pieces would break where its author saw no seam.
TEST_F(OpenSeams, NearlyJoinedEdgesAreNamedWithTheirLength) {
    const std::string hair = two_quads(".00001");
    EXPECT_EQ(connected_components(read("a.obj", hair, repair)).count, 2);
    expect_warning(
        "2 edges lie within 1e-05 m of others without being joined to them (the first: vertices 1 and 2 at "
        "(1, 0.5, 0); total length 2 m), so that the sheet is open there; `join = 2e-05` (m) on the mesh");
    read("a.obj", hair, {.repair = Repair::all, .unit = 0.001});
    expect_warning("total length 0.002 m), so that the sheet is open there; `join = 2e-08`");
    read("a.obj", two_quads(".1"), repair);
    EXPECT_TRUE(warnings.empty()) << "a gap that can be seen may be meant: " << warnings[0];
    read("a.obj", hair, {.repair = Repair::all, .join_advice = ""});
    EXPECT_TRUE(warnings.empty());
}

TEST_F(OpenSeams, NearlyJoinedEdgesAreJoinedWhereThatIsAskedFor) {
    const Mesh mesh = read("a.obj", two_quads(".00001"), joining(2e-5));
    EXPECT_EQ(connected_components(mesh).count, 1);
    EXPECT_EQ(mesh.number_of_vertices(), 6U);
    expect_warning("2 vertices were joined with another within 2e-05 m");
    EXPECT_EQ(warnings.size(), 1U);
    EXPECT_EQ(connected_components(read("a.obj", two_quads(".00001"), joining(5e-6))).count, 2);
    expect_failure("a.obj", two_quads(".00001"), "give a smaller distance", joining(0.6));
    // The inside of a sheet is not changed, however fine it is.
    const std::string fine = test::square + "v .5 .5 0\nv .5001 .5 0\n";
    EXPECT_EQ(read("b.obj", fine + "f 1 2 6\nf 1 6 5\nf 2 3 6\nf 6 3 5\nf 3 4 5\nf 4 1 5\n", joining(0.01))
                  .number_of_vertices(),
              6U);
}

/// Quad of width 2 above two quads of width 1, whose common vertex lies on the quad's lower edge without
/// dividing it.
const std::string tee =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 -1 0\nv 1 -1 0\nv 2 -1 0\nv 1 0 0\n"
    "vt 0 0\nvt 2 0\nvt 2 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\nf 5 6 8 1\nf 6 7 2 8\n";

TEST_F(OpenSeams, VerticesOnEdgesAreNamedWithTheLengthOfTheEdges) {
    const Mesh mesh = read("a.obj", tee, repair);
    EXPECT_EQ(connected_components(mesh).count, 2);
    expect_warning(
        "1 vertex lies on edges without dividing them (T-junctions; the first: vertex 7 on the edge of "
        "vertices 0 and 1 at (1, 0, 0); edges with a total length of 2 m), so that the sheet is open there; "
        "`join = ");
    // A soup whose vertices are joined first gives the same warning.
    read("b.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 -1 0\nf 1 2 3\nf 5 4 6\n", repair);
    expect_warning("vertex 4 on the edge of vertices 0 and 1");
}

TEST_F(OpenSeams, VerticesOnEdgesDivideThemWhereThatIsAskedFor) {
    const Mesh mesh = read("a.obj", tee, joining(1e-6));
    expect_warning("1 edge was divided by vertices that lie on them");
    EXPECT_EQ(connected_components(mesh).count, 1);
    EXPECT_EQ(measure(mesh).boundary_loops, 1);
    EXPECT_EQ(mesh.number_of_faces(), 7U);
    EXPECT_NEAR(area(mesh), 4, 1e-14);
    const auto texture = find_property(mesh, attribute::texture).first;
    EXPECT_EQ(texture[Face(0)][1], Eigen::Vector2d(1, 0)) << "texture coordinates are divided, too";
    // Points on all sides of one triangle, two of them on one side.
    const Mesh star = read("b.obj",
                           "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 1 0 0\nv 2 0 0\nv 1.5 -1 0\nv 0 1.5 0\nv -1 1.5 0\n"
                           "v 1.5 1.5 0\nv 2 2 0\nf 1 2 3\nf 5 4 6\nf 1 7 8\nf 7 3 8\nf 2 10 9\nf 9 10 3\n"
                           "f 4 1 6\nf 2 5 6\n",
                           joining(1e-6));
    EXPECT_EQ(connected_components(star).count, 1);
    EXPECT_EQ(measure(star).boundary_loops, 1);
    EXPECT_EQ(star.number_of_faces(), 12U);
}

}  // namespace
}  // namespace sherd
