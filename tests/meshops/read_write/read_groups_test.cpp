// SPDX-License-Identifier: GPL-3.0-or-later
// With wrong groups, a scene's supports and loads would act on a wrong part of the mesh.
#include <gtest/gtest.h>

#include <algorithm>

#include "meshops/attributes.h"
#include "meshops/face_groups.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

// Strip of three squares along x.
const std::string points = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n";
const std::string left = "f 1 2 6 5\n", middle = "f 2 3 7 6\n", right = "f 3 4 8 7\n";

Mesh read(const std::string& text, const ReadMeshOptions& options = {}) {
    const TemporaryDirectory directory;
    std::vector<std::string> warnings;
    return read_mesh(directory.write("strip.obj", text), options, warnings);
}

/// Smallest and largest x of the vertices in the group; empty if there are none.
std::vector<double> extent(const Mesh& mesh, const std::string& group) {
    std::vector<double> x;
    for (const Vertex v : mesh.vertices())
        if (is_in_group(mesh, v, group)) x.push_back(mesh.point(v).x());
    if (x.empty()) return {};
    const auto [least, largest] = std::minmax_element(x.begin(), x.end());
    return {*least, *largest};
}

using Names = std::vector<std::string>;
using Extent = std::vector<double>;

TEST(ReadGroups, AGroupHoldsTheVerticesOfItsFacesInAllTriangles) {
    const Mesh mesh =
        read(points + "g end\n" + left + "g centre strong # two\r\n" + middle + "g end\n" + right);
    EXPECT_EQ(group_names(mesh), (Names{"centre", "end", "strong"}));
    EXPECT_EQ(extent(mesh, "centre"), (Extent{1, 2}));
    EXPECT_EQ(extent(mesh, "strong"), (Extent{1, 2}));
    EXPECT_EQ(extent(mesh, "end"), (Extent{0, 3}));
    EXPECT_EQ(extent(mesh, "en"), Extent{});
    const auto [groups, exists] = find_property(mesh, attribute::groups);
    ASSERT_TRUE(exists);
    const Names expected[]{{"end"}, {"end"}, {"centre", "strong"}, {"centre", "strong"}, {"end"}, {"end"}};
    for (const Face face : mesh.faces()) EXPECT_EQ(*groups[face], expected[face.idx()]);
}

TEST(ReadGroups, ObjectsAreGroupsBesideThoseOfTheGLines) {
    const Mesh mesh = read(points + "o my plate\ng rim\n" + left + "g\n" + middle + "o other\n" + right);
    EXPECT_EQ(group_names(mesh), (Names{"my plate", "other", "rim"}));
    EXPECT_EQ(extent(mesh, "my plate"), (Extent{0, 2}));
    EXPECT_EQ(extent(mesh, "rim"), (Extent{0, 1})) << "a `g` without a name ends it";
    EXPECT_EQ(extent(mesh, "other"), (Extent{2, 3}));
}

TEST(ReadGroups, FacesBeforeTheFirstLineAreInNoneAndOtherFilesHaveNone) {
    const Mesh some = read(points + left + "g rim\n" + middle + right);
    EXPECT_EQ(extent(some, "rim"), (Extent{1, 3}));
    const Mesh none = read(points + left + middle);
    EXPECT_TRUE(group_names(none).empty());
    EXPECT_EQ(extent(none, "rim"), Extent{});
}

// Flipped, dropped and doubled triangles must keep the groups of their polygon.
TEST(ReadGroups, RepairKeepsGroupsWithTheirFaces) {
    const Mesh mesh = read(points + "g bad\nf 1 2 3\ng low\n" + left + middle + "g high\nf 7 8 4 3\n",
                           {.repair = Repair::all});
    ASSERT_EQ(mesh.number_of_faces(), 6u);
    EXPECT_EQ(group_names(mesh), (Names{"high", "low"}));
    EXPECT_EQ(extent(mesh, "low"), (Extent{0, 2}));
    EXPECT_EQ(extent(mesh, "high"), (Extent{2, 3}));
}

}  // namespace
}  // namespace sherd::test
