// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ and MTL files as other programs write them.
#include <gtest/gtest.h>

#include "meshops/attributes.h"
#include "meshops/face_groups.h"
#include "meshops/surface_material.h"
#include "tests/support/mesh/mesh_reading.h"

namespace sherd {
namespace {

using ReadObj = test::MeshReading;
using test::area, test::triangles, test::Triangles;

// Exporters differ in the text around the numbers: none of it may remove or add a vertex.
TEST_F(ReadObj, ReadsObjHoweverItIsSetOut) {
    const std::string plain = test::square + "f 3 1 2\nf 1 3 4\n";
    const auto ended_by = [&](const std::string& end) {
        std::string text;
        for (const char c : plain) text += c == '\n' ? end : std::string(1, c);
        return text;
    };
    const std::string upper = "V 0 0 0\nV 1 0 0\nV 1 1 0\nV 0 1 0\nF 3 1 2\nF 1 3 4\n";
    const std::string continued =
        "v 0 0 \\ \n 0\nv 1 0 0\n# a comment \\\nv 1 1 0\nv 0 1 0\nf 3 1 2\nf 1 3 4\n";
    for (const std::string& text :
         {"\xEF\xBB\xBF" + plain, ended_by("\r"), ended_by("\r\n"), upper, continued}) {
        const Mesh mesh = read("a.obj", text);
        EXPECT_EQ(triangles(mesh), (Triangles{{2, 0, 1}, {0, 2, 3}})) << text;
        EXPECT_DOUBLE_EQ(area(mesh), 1) << text;
        EXPECT_TRUE(warnings.empty());
    }
    EXPECT_DOUBLE_EQ(area(read("w.obj", "v 0 0 0 1\nv 2 0 0 2\nv 3 3 0 3\nv 0 1 0\nf 1 2 3 4\n")), 1)
        << "a weight divides";
    expect_failure("w0.obj", "v 0 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "weight 0");
    expect_failure("wide.obj", "\xFF\xFEv", "UTF-16");
}

// A user must be told which statements are not read, and why a file has no polygons.
TEST_F(ReadObj, SaysWhichObjStatementsItPassesOver) {
    read("a.obj", test::square + "l 1 2\nl 2 3\nfrobnicate 3\nvn 0 0 1\ns 1\nf 1 2 3 4\n");
    ASSERT_EQ(warnings.size(), 2U);
    expect_warning("2 lines were skipped: polylines (`l`) (the first: line 5");
    expect_warning("1 line was skipped: unknown statements (the first: line 7, `frobnicate`)");
    expect_failure("lines.obj", test::square + "l 1 2\n", "no faces (`f`), only polylines");
    expect_failure("free.obj", test::square + "cstype bezier\nsurf 0 1 0 1 1 2 3 4\nend\n", "free-form");
}

TEST_F(ReadObj, TakesTexturePointsBehindTheFacesThatNameThem) {
    const Mesh mesh = read("a.obj", test::square + "f 1/1 2/2 3/3\nvt 0 0\nvt 1 0\nvt 1 1\n");
    const auto [texture, exists] = find_property(mesh, attribute::texture);
    ASSERT_TRUE(exists);
    EXPECT_EQ(texture[Face(0)][2], Eigen::Vector2d(1, 1));
    expect_failure("b.obj", test::square + "f 1/1 2/2 3/4\nvt 0 0\nvt 1 0\nvt 1 1\n", "texture point");
}

// Materials must be found by names with blanks, quotes or comment signs.
TEST_F(ReadObj, FindsMaterialsByTheNamesThatExportersWrite) {
    directory.write("m#2.mtl", "\xEF\xBB\xBFnewmtl red  glass\rKd 1 0 0\r");
    const Mesh mesh =
        read("a.obj", "mtllib m#2.mtl\n" + test::square + "usemtl \"red glass\" # of old\nf 1 2 3 4\n");
    EXPECT_TRUE(warnings.empty()) << warnings[0];
    const auto [material, exists] = find_property(mesh, attribute::surface_material);
    ASSERT_TRUE(exists);
    EXPECT_EQ(material[Face(0)]->name, "red glass");
    EXPECT_NE(material[Face(0)]->definition.find("Kd 1 0 0"), std::string::npos);
}

// Names are written to scenes, HDF5, XML and JSON, which are UTF-8: other names would end a run at its
// export.
TEST_F(ReadObj, TakesNamesThatAreNotUtf8ForLatin1) {
    directory.write("a.mtl", "newmtl gr\xFCn\nKd 0 1 0\n");
    for (const std::string name : {"gr\xFCn", "gr\xC3\xBCn"}) {
        const Mesh mesh = read(
            "a.obj", "mtllib a.mtl\n" + test::square + "g " + name + "\nusemtl " + name + "\nf 1 2 3 4\n");
        const auto material = find_property(mesh, attribute::surface_material).first;
        EXPECT_EQ(material[Face(0)]->name, "gr\xC3\xBCn");
        EXPECT_FALSE(material[Face(0)]->definition.empty());
        EXPECT_EQ(group_names(mesh), (std::vector<std::string>{"gr\xC3\xBCn"}));
    }
}

}  // namespace
}  // namespace sherd
