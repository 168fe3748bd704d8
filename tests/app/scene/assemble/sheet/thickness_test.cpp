// SPDX-License-Identifier: GPL-3.0-or-later
// If one of these tests failed, a sheet would be thin in other places than its map says.
#include "app/scene/assemble/sheet/thickness.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/read/scene.h"
#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/write_mesh.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/mesh/vdb_file.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/png_file.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

constexpr Colour16 grey{21845, 21845, 21845}, bright{65535, 65535, 65535};  // a third of white, and white

class ThicknessMaps : public testing::Test {
  protected:
    ThicknessMaps() {
        TriangleSheet square = triangle_sheet(grid(4, 4));
        for (Vector3d& point : square.points) point /= 4;
        for (const auto& triangle : square.triangles) {
            FaceTexture& corners = square.look.texture.emplace_back();
            for (int i = 0; i < 3; ++i) corners[i] = square.points[triangle[i]].head<2>();
        }
        write_mesh(square, directory.path / "square.obj");
        write_png(directory.path / "a.png", 2, 1, {grey, bright});
        directory.write("square.ply", with_property("0.002", "0.004"));
    }
    /// Text of a PLY file of a square of two triangles, and of a vertex that no face uses. left, right:
    /// values of the property `thick`.
    static std::string with_property(const std::string& left, const std::string& right) {
        return "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float "
               "z\n"
               "property double thick\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
               "9 9 9 -1\n0 0 0 " +
               left + "\n1 0 0 " + right + "\n1 1 0 " + right + "\n0 1 0 " + left + "\n3 1 2 3\n3 1 3 4\n";
    }
    std::string text(const std::string& thickness, const std::string& mesh = "\"square.obj\"") const {
        return "duration = 1e-3\n[sheet.square]\nmesh = " + mesh +
               "\nmaterial = { preset = \"glass\", thickness = " + thickness + " }\n";
    }
    SheetInput input(const std::string& thickness, const std::string& mesh = "\"square.obj\"") {
        const Scene scene = read_scene(directory.write("scene.toml", text(thickness, mesh)));
        std::vector<std::string> found;
        SheetInput made = make_sheet(scene.sheets[0], scene, found);
        for (const std::string& warning : found)
            if (warning.find("material.thickness") != std::string::npos) warnings.push_back(warning);
        return made;
    }
    std::string message_of(const std::string& thickness, const std::string& mesh = "\"square.obj\"") {
        return message_thrown_by([&] { input(thickness, mesh); });
    }
    TemporaryDirectory directory;
    std::vector<std::string> warnings;
};

TEST_F(ThicknessMaps, OfOneNumberIsThisNumber) {
    const SheetInput plain = input("0.003");
    EXPECT_TRUE(plain.thickness.empty());
    const SheetInput mapped = input("{ texture = \"a.png\", range = [0.003, 0.003] }");
    ASSERT_EQ(mapped.thickness.size(), mapped.mesh.number_of_vertices());
    for (const double thickness : mapped.thickness) EXPECT_EQ(thickness, 0.003);
    EXPECT_EQ(mapped.material.thickness, 0.003);
}

// Between the centres of the two texels, at u = 1/4 and 3/4, the thickness must be linear.
TEST_F(ThicknessMaps, TextureIsLookedUpAtTheVertices) {
    const SheetInput ranged = input("{ texture = \"a.png\", range = [0.006, 0.002] }");
    const SheetInput scaled = input("{ texture = \"a.png\", scale = 0.008 }",
                                    "\"square.obj\"\nplace = { "
                                    "translate = [0, 0, 3] }");
    for (const Vertex v : ranged.mesh.vertices())
        if (const double u = position(ranged.mesh, v).x(); u == 0.5) {
            EXPECT_NEAR(ranged.thickness[v], 0.006 - 0.004 * 2 / 3, 1e-9);
            EXPECT_NEAR(scaled.thickness[v], 0.008 * 2 / 3, 1e-9);
        } else if (u == 0.25 || u == 0.75) {
            EXPECT_NEAR(ranged.thickness[v], u < 0.5 ? 0.006 - 0.004 / 3 : 0.002, 1e-9);
        }
    EXPECT_NEAR(ranged.material.thickness, 0.006 - 0.004 * 2 / 3, 1e-9);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
}

// Remeshing must not move the thin places: the property must remain linear over the file's triangles.
TEST_F(ThicknessMaps, PropertyReachesRemeshedMeshes) {
    const SheetInput made = input("{ property = \"thick\" }", "{ file = \"square.ply\", remesh = 0.1 }");
    EXPECT_GT(made.mesh.number_of_faces(), 150u);
    for (const Vertex v : made.mesh.vertices())
        EXPECT_NEAR(made.thickness[v], 0.002 + 0.002 * position(made.mesh, v).x(), 1e-12);
}

// Remeshing must not move texture coordinates, and with them the thin places, either.
TEST_F(ThicknessMaps, TextureReachesRemeshedMeshes) {
    const SheetInput made =
        input("{ texture = \"a.png\", range = [0.006, 0.002] }", "{ file = \"square.obj\", remesh = 0.07 }");
    EXPECT_GT(made.mesh.number_of_faces(), 300u);
    for (const Vertex v : made.mesh.vertices())
        if (const double u = position(made.mesh, v).x(); u > 0.25 && u < 0.75) {
            const double value = 1.0 / 3 + 2.0 / 3 * (u - 0.25) / 0.5;
            EXPECT_NEAR(made.thickness[v], 0.006 - 0.004 * value, 1e-7);
        }
}

// A grid must move with the mesh when the scene scales and places it, but its values are in metres and must
// not be scaled.
TEST_F(ThicknessMaps, GridMovesWithTheMesh) {
    const auto value = [](double x, double y, double) { return 0.001 + 0.002 * x + 0.001 * y; };
    write_vdb(directory.path / "t.vdb", {vdb_grid("t", 0.1, {{-2, -2, -2}, {12, 12, 2}}, 1.0f, value)});
    const std::string moved =
        "{ file = \"square.obj\", scale = 0.5 }\nplace = { translate = [1, 2, 3], rotate "
        "= { axis = [1, 2, 3], degrees = 50 } }";
    const SheetInput plain = input("{ vdb = \"t.vdb\" }");
    const SheetInput placed = input("{ vdb = \"t.vdb\", grid = \"t\", scale = 2 }", moved);
    for (const Vertex v : plain.mesh.vertices()) {
        const Vector3d at = position(plain.mesh, v);
        EXPECT_NEAR(plain.thickness[v], value(at.x(), at.y(), 0), 1e-7);
        EXPECT_NEAR(placed.thickness[v], 2 * plain.thickness[v], 1e-7);
    }
    EXPECT_NEAR(plain.material.thickness, value(0.5, 0.5, 0), 1e-7) << "the mean by area";
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    write_vdb(directory.path / "t.vdb", {vdb_grid("t", 0.1, {{-2, -2, -2}, {5, 12, 2}}, 0.5f, value)});
    input("{ vdb = \"t.vdb\" }");
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("sheet.square.material.thickness.vdb: 10 of 25 vertices lie outside"),
              std::string::npos)
        << warnings[0];
}

TEST_F(ThicknessMaps, PropertyIsThatOfTheFilesVertices) {
    const SheetInput made = input("{ property = \"thick\" }", "\"square.ply\"");
    const SheetInput scaled = input("{ property = \"thick\", range = [0.001, 1.001] }", "\"square.ply\"");
    for (const Vertex v : made.mesh.vertices()) {
        const double expected = position(made.mesh, v).x() < 0.5 ? 0.002 : 0.004;
        EXPECT_EQ(made.thickness[v], expected);
        EXPECT_NEAR(scaled.thickness[v], expected + 0.001, 1e-15);
    }
}

// Strength maps may use a property of vertices, too: an edge has the mean of the values at its ends.
TEST_F(ThicknessMaps, PropertyMayBeAStrengthToo) {
    const Scene scene = read_scene(directory.write(
        "scene.toml", text("0.003", "\"square.ply\"") +
                          "fracture = { strain = 10, map = { property = \"thick\", range = [0, 1000] } }\n"));
    std::vector<std::string> found;
    const SheetInput made = make_sheet(scene.sheets[0], scene, found);
    ASSERT_EQ(made.strength.factors.size(), made.mesh.number_of_edges());
    for (const Edge e : made.mesh.edges()) {
        const double middle =
            0.5 *
            (position(made.mesh, made.mesh.vertex(e, 0)) + position(made.mesh, made.mesh.vertex(e, 1))).x();
        EXPECT_NEAR(made.strength.factors[e], 2 + 2 * middle, 1e-12);
    }
}

TEST_F(ThicknessMaps, WhatIsNotAThicknessIsNamedWithItsPlace) {
    directory.write("bad.ply", with_property("0.002", "0"));
    EXPECT_NE(
        message_of("{ property = \"thick\" }", "\"bad.ply\"")
            .find("scene.toml:4: sheet.square.material.thickness.property: the property thick is 0 at vertex "
                  "1, at (1, 0, 0) m, which makes the sheet 0 m thick: it needs a thickness above 0"),
        std::string::npos);
    directory.write("bad.ply", with_property("0.002", "nan"));
    EXPECT_NE(message_of("{ property = \"thick\" }", "\"bad.ply\""), "no error");
    const auto value = [](double x, double, double) { return x > 0.85 ? -2 : 1.0; };
    write_vdb(directory.path / "t.vdb", {vdb_grid("t", 0.1, {{-2, -2, -2}, {12, 12, 2}}, 1.0f, value)});
    EXPECT_NE(message_of("{ vdb = \"t.vdb\", scale = 1e-3 }").find("makes the sheet -0.002 m thick"),
              std::string::npos);
}

struct BadThickness {
    const char *name, *thickness, *message;
    const char* mesh = "\"square.obj\"";
};

class BadThicknessMaps : public ThicknessMaps, public testing::WithParamInterface<BadThickness> {};

TEST_P(BadThicknessMaps, AreRefusedByTheirPlace) {
    const std::string message = message_of(GetParam().thickness, GetParam().mesh);
    EXPECT_NE(message.find("scene.toml:4: sheet.square.material.thickness"), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

constexpr const char* generated_disc = "{ generate = \"disc\", radius = 0.1, edge_length = 0.05 }";
INSTANTIATE_TEST_SUITE_P(
    All, BadThicknessMaps,
    testing::Values(
        BadThickness{"nothing", "{ range = [1, 2] }", "thickness: needs one of texture, vdb and property"},
        BadThickness{"two", "{ vdb = \"a.vdb\", property = \"t\" }",
                     "vdb: conflicts with property: give one of them"},
        BadThickness{"no_range", "{ texture = \"a.png\" }",
                     "thickness: needs range, the thickness (m) of black and of white"},
        BadThickness{"range_and_scale", "{ vdb = \"a.vdb\", range = [1, 2], scale = 3 }",
                     "thickness.scale: conflicts with range"},
        BadThickness{"nothing_thick", "{ texture = \"a.png\", range = [0, 0.002] }",
                     "thickness.range: must be"},
        BadThickness{"negative_scale", "{ vdb = \"a.vdb\", scale = -1 }",
                     "scale: must be a positive number (m)"},
        BadThickness{"misspelt", "{ texture = \"a.png\", rnage = [1, 2] }", "did you mean 'range'?"},
        BadThickness{"word", "\"thin\"", "thickness: must be a positive number (m)"},
        BadThickness{"no_file", "{ texture = \"no.png\", range = [1e-3, 2e-3] }", "thickness.texture: "},
        BadThickness{"no_texture", "{ texture = \"a.png\", range = [1e-3, 2e-3] }",
                     "the mesh has no texture coordinates", generated_disc},
        BadThickness{
            "no_property", "{ property = \"thin\" }",
            "square.ply:3: element vertex of the PLY file has no number `thin`; it has x, y, z, thick",
            "\"square.ply\""},
        BadThickness{"no_ply", "{ property = \"thin\" }",
                     "square.obj: only a PLY file has properties of its vertices"},
        BadThickness{"generated", "{ property = \"thin\" }",
                     "the mesh is not from a file, so it has no properties: give a PLY file",
                     generated_disc}),
    [](const auto& input) { return input.param.name; });

TEST_F(ThicknessMaps, OfAMaterialFileIsANumber) {
    directory.write("material.toml",
                    "preset = \"glass\"\nthickness = { texture = \"a.png\", range = [1, 2] }\n");
    const ProgramResult result =
        run_sherd({"probe", "square.obj", "square.obj", "--material", "material.toml"}, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("material.toml:2: thickness: must be a positive number (m), not a table"),
              std::string::npos)
        << result.err;
}

TEST_F(ThicknessMaps, CheckTellsTheRangeAndTheMass) {
    directory.write("scene.toml",
                    text("{ property = \"thick\" }", "\"square.ply\"") + "fracture = { strain = 10 }\n");
    const ProgramResult result = run_sherd({"check", "scene.toml", "--no-try"}, directory.path);
    for (const char* line : {"area 1 m^2, mass 7.5 kg\n", "thickness 0.002 to 0.004 m, 0.003 m on average\n",
                             "breaks above 10 1/m, 0.01 to 0.02 of strain at its surface\n"})
        EXPECT_NE(result.out.find(line), std::string::npos) << result.out << result.err;
}

// The command line can replace a table by a number like any other value.
TEST_F(ThicknessMaps, AreReplacedByANumber) {
    const Scene scene =
        read_scene(directory.write("scene.toml", text("{ property = \"thick\" }", "\"square.ply\"")),
                   {.overrides = {"sheet.square.material.thickness=0.005"}, .variant = ""});
    EXPECT_FALSE(scene.sheets[0].thickness);
    EXPECT_EQ(scene.sheets[0].material.thickness, 0.005);
}

}  // namespace
}  // namespace sherd::test
