// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of a material must be those of the file, and inadmissible constants must be refused by name:
// a run with them would gain energy.
#include <gtest/gtest.h>

#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/read/scene.h"
#include "tests/support/mesh/ply_square.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/png_file.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scene_of.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

std::string scene_with(const std::string& material, const std::string& mesh = "") {
    const std::string shape = R"({ generate = "disc", radius = 0.1, edge_length = 0.03 })";
    return "duration = 0.0002\n[sheet.plate]\nmesh = " + (mesh.empty() ? shape : mesh) +
           "\n[sheet.plate.material]\npreset = \"cotton\"\n" + material + "\n";
}

Scene scene_made_of(const std::string& material) {
    const TemporaryDirectory directory;
    return read_scene(directory.write("scene.toml", scene_with(material)));
}

// Constants that are missing because the preset is unknown must not be reported as further mistakes.
TEST(SceneMaterial, APresetThatIsNotKnownIsOneMistake) {
    std::string text = scene_with("");
    text.replace(text.find("cotton"), 6, "coton");
    const std::string said = message_thrown_by([&] { scene_of(text); });
    EXPECT_NE(said.find("did you mean \"cotton\"?"), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
}

TEST(SceneMaterial, OrthotropicConstantsArrive) {
    const Material m = scene_made_of(
                           "young = [4e6, 1e6]\npoisson = 0.6\nshear = 2e5\ncalibration = \"paper\"\n"
                           "[solver]\nbending = \"cubic\"")
                           .sheets[0]
                           .material;
    EXPECT_EQ(m.density, 500) << "of the preset";
    EXPECT_EQ(m.young, 4e6);
    EXPECT_EQ(m.young1, 1e6);
    EXPECT_EQ(m.poisson, 0.6) << "more than an isotropic sheet may have";
    EXPECT_EQ(m.shear, 2e5);
    EXPECT_EQ(m.calibration, Calibration::paper);
    const Material coupled = scene_made_of("young = [4e6, 1e6]\nyoung01 = 3e5").sheets[0].material;
    EXPECT_DOUBLE_EQ(coupled.poisson, 0.3);
    EXPECT_FALSE(coupled.shear) << "Huber's";
    const Material plain = scene_made_of("").sheets[0].material;
    EXPECT_TRUE(is_isotropic(plain));
    EXPECT_EQ(plain.calibration, Calibration::third);
}

// Birch plywood is stiffer along its outer plies. A given modulus must replace both moduli of the preset.
TEST(SceneMaterial, APresetMayHaveDirections) {
    const auto made_of = [](const std::string& more) {
        return scene_of(
                   "duration = 1\n[sheet.a]\nmesh = { generate = \"disc\", radius = 1, edge_length = 0.5 }\n"
                   "material = { preset = \"plywood\"" +
                   more + " }\n")
            .sheets[0]
            .material;
    };
    const Material plywood = made_of("");
    EXPECT_EQ(plywood.young, 1.27e10);
    EXPECT_EQ(plywood.young1, 4.8e9);
    EXPECT_EQ(plywood.shear, 6.2e8);
    EXPECT_TRUE(is_isotropic(made_of(", young = 9e9")));
}

TEST(SceneMaterial, AxisArrivesAndTurnsWithTheSheet) {
    const MaterialAxis axis = scene_made_of("axis = { degrees = 45 }").sheets[0].axis;
    EXPECT_EQ(std::get<AxisDirection>(axis.kind).degrees, 45);
    EXPECT_EQ(std::get<AxisDirection>(scene_made_of("").sheets[0].axis.kind).degrees, 0);
    const MaterialAxis along = scene_made_of("axis = { direction = [0, 0, 2] }").sheets[0].axis;
    EXPECT_EQ(std::get<AxisDirection>(along.kind).direction, Vector3d(0, 0, 1));
    const MaterialAxis around =
        scene_made_of("axis = { direction = [0, 0, 1], degrees = 90 }").sheets[0].axis;
    EXPECT_EQ(std::get<AxisDirection>(around.kind).direction, Vector3d(0, 0, 1));
    EXPECT_EQ(std::get<AxisDirection>(around.kind).degrees, 90);
    const MaterialAxis texture =
        scene_made_of("axis = { texture = \"a.png\", encoding = \"vector\" }").sheets[0].axis;
    EXPECT_EQ(std::get<AxisTexture>(texture.kind).path.filename(), "a.png");
    EXPECT_EQ(std::get<AxisTexture>(texture.kind).encoding, AxisEncoding::vector);

    const Scene scene = scene_made_of("young = [4e6, 1e6]\naxis = { degrees = 90 }");
    std::vector<std::string> warnings;
    const SheetInput input = make_sheet(scene.sheets[0], scene, warnings);
    ASSERT_EQ(input.axes.size(), input.mesh.number_of_faces());
    for (const Vector3d& found : input.axes) EXPECT_LT((found - Vector3d::UnitY()).norm(), 1e-14);
}

struct BadMaterial {
    std::string material;
    std::string message;
    std::string mesh = {};
};

const std::vector<BadMaterial> bad_materials{
    {"young = [4e6, 1e6]\npoisson = 2.5",
     "scene.toml:7: sheet.plate.material.poisson: is inadmissible, Y01^2 < Y0 Y1 fails: Y01 = nu01 Y1 = "
     "2.5e+06 "
     "Pa, Y01^2 = 6.25e+12 Pa^2, Y0 Y1 = 4e+12 Pa^2"},
    {"young = [4e6, 1e6]\nyoung01 = 2e6", "scene.toml:7: sheet.plate.material.young01: is inadmissible"},
    {"young = [1e4, 1e6]", "scene.toml:6: sheet.plate.material.young: is inadmissible"},
    {"young = [4e6, 1e6]\nshear = 0",
     "scene.toml:7: sheet.plate.material.shear: must be a positive number (Pa)"},
    {"young = [4e6, -1]",
     "scene.toml:6: sheet.plate.material.young: must be a positive number, or an array of 2"},
    {"young = [4e6]", "material.young: must be a positive number, or an array of 2 of them (Pa)"},
    {"young01 = 1\npoisson = 0.1", "scene.toml:6: sheet.plate.material.young01: conflicts with poisson"},
    {"poisson = 0.6", "poisson: must be a number between -1 and 0.5"},
    {"calibration = \"thrid\"", "calibration: must be one of \"third\", \"paper\""},
    {"young = [4e6, 1e6]\ntempered = 1e8",
     "scene.toml:7: sheet.plate.material.tempered: needs an isotropic material"},
    {"tempered = -1", "material.tempered: must be"},
    {"axis = { degres = 3 }", "material.axis.degres: unknown key"},
    {"axis = {}", "scene.toml:6: sheet.plate.material.axis: needs direction, degrees or both"},
    {"axis = { degrees = 1, field = true }", "axis: needs direction, degrees or both"},
    {"axis = { direction = [0, 0, 0] }", "axis.direction: must not be zero"},
    {"axis = { degrees = 1, encoding = \"hue\" }", "axis.encoding: needs texture"},
    {"axis = { texture = \"no.png\" }",
     "scene.toml:6: sheet.plate.material.axis.texture: no.png: cannot read the image: No such file"},
    {"axis = { texture = \"scene.toml\" }", "material.axis.texture: scene.toml: is not a PNG file"},
    {"axis = { texture = \"red.png\" }", "material.axis.texture: the mesh has no texture coordinates"},
    {"axis = { texture = \"red.png\" }",
     "axis.texture: the texture coordinates of face 0 at (0.6667, 0.3333, 0) m have no area", "\"flat.obj\""},
    {"axis = { field = true }", "material.axis.field: the mesh has no axes"},
    {"axis = { field = true }",
     "material.axis.field: the axis of face 1 at (0.3333, 0.6667, 0) m, [0, 0, 3], has no direction",
     "\"field.ply\""},
    {"axis = { field = false }", "material.axis.field: must be true"},
    {"axis = { texture = \"grey.png\" }",
     "axis.texture: grey.png has no direction on face 0 at (0.6667, 0.3333, 0) m", "\"good.obj\""},
};

TEST(SceneMaterial, WhatCannotBeIsRefusedByKeyAndNothingIsWritten) {
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\n", face = "f 1/1 2/2 3/3\n";
    for (const BadMaterial& bad : bad_materials) {
        const TemporaryDirectory directory;
        directory.write("scene.toml", scene_with(bad.material, bad.mesh));
        directory.write("flat.obj", square + "vt 0 0\nvt 1 1\nvt 2 2\n" + face);
        directory.write("good.obj", square + "vt 0 0\nvt 1 0\nvt 1 1\n" + face);
        directory.write("field.ply", ply_square("1 2 0", "0 0 3"));
        write_png(directory.path / "red.png", 2, 2, {65535, 0, 0});
        write_png(directory.path / "grey.png", 2, 2, {5, 5, 5});
        const auto before = directory.contents();
        for (const std::string command : {"check", "run"}) {
            const ProgramResult result = run_sherd({command, "scene.toml"}, directory.path);
            EXPECT_EQ(result.exit_code, 2) << bad.material << result.out << result.err;
            EXPECT_NE(result.err.find(bad.message), std::string::npos)
                << "no '" << bad.message << "' in: " << result.err;
        }
        EXPECT_EQ(directory.contents(), before);
    }
}

TEST(SceneMaterial, SheetsTooStiffInBendingAreWarnedOf) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", scene_with("young = [4e6, 1e6]"));
    const ProgramResult thin = run_sherd({"run", "scene.toml"}, directory.path);
    EXPECT_EQ(thin.exit_code, 0) << thin.err;
    EXPECT_EQ(thin.err.find("warning"), std::string::npos) << thin.err;
    const ProgramResult thick =
        run_sherd({"check", "scene.toml", "--set", "sheet.plate.material.thickness=0.025"}, directory.path);
    EXPECT_EQ(thick.exit_code, 0) << thick.err;
    EXPECT_NE(thick.out.find("stretching stiffness Y t is"), std::string::npos) << thick.out;
}

}  // namespace
}  // namespace sherd::test
