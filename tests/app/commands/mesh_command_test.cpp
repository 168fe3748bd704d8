// SPDX-License-Identifier: GPL-3.0-or-later
// `sherd mesh`: artists paint on the mesh that it writes, which must be the mesh of the scene's run.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/scene/assemble/sheet/mesh.h"
#include "app/scene/read/scene.h"
#include "meshops/attributes.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string disc_scene = R"({ generate = "disc", radius = 0.1, edge_length = 0.03 })";
const std::string turned = "translate = [1, 2, 3], rotate = { axis = [1, 0, 0], degrees = 30 }";

std::string sheet_table(const std::string& name, const std::string& mesh, const std::string& place = turned) {
    return "[sheet." + name + "]\nmesh = " + mesh + "\nplace = { " + place +
           " }\nmaterial = { preset = \"stoneware\" }\n";
}

class MeshCommand : public testing::Test {
  protected:
    ProgramResult mesh(const std::string& sheets, const std::vector<std::string>& arguments) {
        directory.write("scene.toml", "duration = 1\n" + sheets);
        std::vector<std::string> all{"mesh", "scene.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_sherd(all, directory.path);
    }
    Mesh read(const std::string& name) {
        std::vector<std::string> warnings;
        return read_mesh(directory.path / name, {}, warnings);
    }
    /// Mesh of a sheet of the scene that was written last, as placed by the scene or not.
    Mesh made(bool placed, std::size_t sheet = 0) {
        std::vector<std::string> warnings;
        const Scene scene = read_scene(directory.path / "scene.toml");
        return placed ? make_mesh(scene.sheets[sheet], scene, warnings)
                      : make_unplaced_mesh(scene.sheets[sheet], scene, warnings);
    }
    void expect_same(const Mesh& a, const Mesh& b, double tolerance = 0) {
        ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
        EXPECT_EQ(triangles_of(a), triangles_of(b));
        for (const Vertex v : a.vertices()) EXPECT_LE((position(a, v) - position(b, v)).norm(), tolerance);
    }

    TemporaryDirectory directory;
};

TEST_F(MeshCommand, WritesTheMeshOfTheSceneToTheLastBit) {
    for (const std::string file : {"a.obj", "a.ply", "a.off"}) {
        const ProgramResult result = mesh(sheet_table("plate", disc_scene), {"-o", file});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out, file + "\n");
        expect_same(read(file), made(false));
    }
    ASSERT_EQ(mesh(sheet_table("plate", disc_scene), {"-o", "a.stl"}).exit_code, 0);
    EXPECT_EQ(read("a.stl").number_of_vertices(), made(false).number_of_vertices());
    // Conversely, the scene with the file in place of the generator must have the same mesh.
    const Mesh generated = made(true);
    ASSERT_EQ(mesh(sheet_table("plate", "\"a.obj\""), {"-o", "b.obj"}).exit_code, 0);
    expect_same(made(true), generated);
}

TEST_F(MeshCommand, WritesThemPlacedWhereThatIsAskedFor) {
    ASSERT_EQ(mesh(sheet_table("plate", disc_scene), {"-o", "a.ply", "--placed"}).exit_code, 0);
    expect_same(read("a.ply"), made(true), 1e-15);
}

TEST_F(MeshCommand, WritesMeshesThatWereScaledAndRemeshed) {
    directory.write("square.obj", "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3 4\n");
    ASSERT_EQ(
        mesh(sheet_table("plate", "{ file = \"square.obj\", scale = 0.01, remesh = 0.02 }"), {"-o", "a.obj"})
            .exit_code,
        0);
    EXPECT_GT(read("a.obj").number_of_faces(), 20u);
    EXPECT_NEAR(measure(read("a.obj")).area, 0.01, 1e-12);
}

// The length `join` is in metres, whatever the unit of the file: if it were scaled by 1000, all or no
// vertices would be joined.
TEST_F(MeshCommand, JoinsWhatIsSoNearInMetres) {
    directory.write(
        "halves.obj",
        "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 10.001 0 0\nv 20 0 0\nv 20 10 0\nv 10.001 10 0\n"
        "f 1 2 3 4\nf 5 6 7 8\n");
    const auto vertices = [&](const std::string& join) {
        const std::string file = "{ file = \"halves.obj\", scale = 0.01, join = " + join + " }";
        EXPECT_EQ(mesh(sheet_table("plate", file), {"-o", "a.obj", "--force"}).exit_code, 0);
        return read("a.obj").number_of_vertices();
    };
    EXPECT_EQ(vertices("2e-5"), 6u);
    EXPECT_EQ(vertices("5e-6"), 8u);
    EXPECT_EQ(vertices("true"), 8u);
}

TEST_F(MeshCommand, ReadsScenesWithTheLineEndsOfOtherSystems) {
    std::string scene = std::string("\xEF\xBB\xBF") + "duration = 1\n" + sheet_table("plate", disc_scene);
    std::ranges::replace(scene, '\n', '\r');
    directory.write("scene.toml", scene);
    EXPECT_EQ(run_sherd({"mesh", "scene.toml", "-o", "a.obj"}, directory.path).exit_code, 0);
}

TEST_F(MeshCommand, SheetsAreObjectsOfOneObjAndFilesOfOtherFormats) {
    directory.write("painted.obj",
                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\ng left\nf 1/1 2/2 3/3\n");
    const std::string both = sheet_table("old", "\"painted.obj\"") + sheet_table("new", disc_scene);
    ASSERT_EQ(mesh(both, {"-o", "all.obj"}).exit_code, 0);
    const Mesh all = read("all.obj");
    EXPECT_EQ(all.number_of_faces(), 1 + made(false, 1).number_of_faces());
    EXPECT_EQ(group_names(all), (std::vector<std::string>{"left", "new", "old"}));
    int left = 0;
    for (const Vertex v : all.vertices()) left += is_in_group(all, v, "left");
    EXPECT_EQ(left, 3) << "a group of one sheet goes on in the next";
    const auto texture = find_property(all, attribute::texture);
    ASSERT_TRUE(texture.second);
    EXPECT_EQ(texture.first[Face(0)][2], Eigen::Vector2d(0, 1));

    const ProgramResult files = mesh(both, {"-o", "all.ply"});
    EXPECT_EQ(files.out, "all-old.ply\nall-new.ply\n") << files.err;
    expect_same(read("all-new.ply"), made(false, 1));
    ASSERT_EQ(mesh(both, {"-o", "one.obj", "--sheet", "old"}).exit_code, 0);
    const std::string odd = sheet_table("\"a/b\"", disc_scene) + sheet_table("\"a b\"", disc_scene);
    EXPECT_EQ(mesh(odd, {"-o", "odd.ply"}).out, "odd-a_b.ply\nodd-a_b_2.ply\n");
    EXPECT_EQ(group_names(read("one.obj")), (std::vector<std::string>{"left"}));
}

TEST_F(MeshCommand, OverridesAndVariantsAreThoseOfTheScene) {
    const std::string variants = sheet_table("plate", disc_scene) +
                                 "[[variant]]\nname = \"coarse\"\nsheet.plate.mesh.edge_length = 0.05\n"
                                 "[[variant]]\nname = \"fine\"\nsheet.plate.mesh.edge_length = 0.02\n";
    // --set and variants replace an inline table as a whole, so that this scene's mesh is no inline table.
    const std::string open =
        "[sheet.plate]\nplace = {}\nmaterial = { preset = \"stoneware\" }\n[sheet.plate.mesh]\n"
        "generate = \"disc\"\nradius = 0.1\nedge_length = 0.03\n" +
        variants.substr(variants.find("[[variant]]"));
    EXPECT_EQ(mesh(open, {"-o", "a.off"}).out, "a-coarse.off\na-fine.off\n");
    EXPECT_LT(read("a-coarse.off").number_of_faces(), read("a-fine.off").number_of_faces());
    EXPECT_EQ(mesh(open, {"-o", "b.off", "--variant", "fine", "--set", "sheet.plate.mesh.radius=0.05"}).out,
              "b-fine.off\n");
    EXPECT_LT(read("b-fine.off").number_of_faces(), read("a-fine.off").number_of_faces());
}

TEST_F(MeshCommand, RefusesWhatWouldBeLost) {
    const auto refused = [&](const std::string& sheets, const std::vector<std::string>& arguments,
                             const std::string& message) {
        directory.write("scene.toml", "duration = 1\n" + sheets);
        const auto before = directory.contents();
        const ProgramResult result = mesh(sheets, arguments);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_EQ(directory.contents(), before);
    };
    directory.write("there.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    refused(sheet_table("a", disc_scene), {"-o", "there.obj"}, "'there.obj' exists");
    refused(sheet_table("a", "\"there.obj\""), {"-o", "there.obj", "--force"}, "is read by this command");
    refused(sheet_table("a", disc_scene), {"-o", "a.gltf"}, "none of .obj, .ply, .off and .stl");
    refused(sheet_table("plate", disc_scene), {"-o", "a.obj", "--sheet", "palte"}, "did you mean 'plate'?");
    refused(sheet_table("a", "{ generate = \"disc\", radius = 0.1, edge_length = 3 }"), {"-o", "a.obj"},
            "edge_length");
    EXPECT_EQ(mesh(sheet_table("a", disc_scene), {"-o", "there.obj", "--force"}).exit_code, 0);
}

}  // namespace
}  // namespace sherd::test
