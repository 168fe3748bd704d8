// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of faults must colour the triangles that the reader refuses.
#include "meshops/read_write/mesh_faults.h"

#include <gtest/gtest.h>

#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using enum TriangleFault;

std::vector<TriangleFault> faults_of(const std::string& obj, bool join = false) {
    const TemporaryDirectory directory;
    const FaultyMesh mesh = find_mesh_faults(directory.write("a.obj", obj), join);
    EXPECT_EQ(mesh.sheet.triangles.size(), mesh.faults.size());
    return mesh.faults;
}

const std::string square_vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(MeshFaults, AGoodMeshHasNone) {
    EXPECT_EQ(faults_of(square_vertices + "f 1 2 3 4\n"), (std::vector{none, none}));
}

TEST(MeshFaults, FlatTrianglesTakeTheirNeighboursAlong) {
    EXPECT_EQ(faults_of(square_vertices + "v 0.5 0 0\nv 5 5 5\nf 1 2 3\nf 1 5 2\nf 3 4 6\n"),
              (std::vector{zero_area, zero_area, none}));
}

TEST(MeshFaults, ARepeatedTriangleIsTheLaterOneAndMakesNoEdgeNonManifold) {
    EXPECT_EQ(faults_of(square_vertices + "f 1 2 3\nf 1 3 4\nf 3 2 1\n"),
              (std::vector{none, none, repeated}));
}

TEST(MeshFaults, AllFacesOfANonManifoldEdgeAreMarked) {
    const std::string book =
        square_vertices + "v 0.5 0.5 1\nv 2 2 2\nf 1 2 3\nf 1 1 2\nf 1 3 4\nf 1 3 5\nf 3 6 4\n";
    EXPECT_EQ(faults_of(book), (std::vector{non_manifold, zero_area, non_manifold, non_manifold, none}));
}

TEST(MeshFaults, PointsAreJoinedFirstWhereThatIsAskedFor) {
    const std::string twice = square_vertices + "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 7\n";
    EXPECT_EQ(faults_of(twice), (std::vector{none, none}));
    EXPECT_EQ(faults_of(twice, true), (std::vector{none, repeated}));
}

}  // namespace
}  // namespace sherd::test
