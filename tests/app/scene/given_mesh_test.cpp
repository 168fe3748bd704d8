// SPDX-License-Identifier: GPL-3.0-or-later
// A program that gives a scene a mesh as plain arrays knows vertices and faces by their rows, which must be
// their numbers in the mesh.
#include <gtest/gtest.h>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

const std::string sheet = R"(duration = 1
[sheet.kite]
place = { translate = [0, 0, 2] }
material = { preset = "glass" }
)";

GivenMeshes kite() {
    return {{"kite", {{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{2, 1, 0}, {0, 3, 2}}}}};
}

TEST(GivenMesh, KeepsItsNumbers) {
    const Scene scene = parse_scene(sheet + "mesh = { given = \"kite\" }\n", "a.toml", {}, kite());
    std::vector<std::string> warnings;
    const BuiltScene built = build_scene(scene, warnings);
    const Shell& shell = built.sheets.mechanics();
    EXPECT_EQ(Vector3d(shell.rest.col(3)), Vector3d(1, 1, 2));
    EXPECT_EQ(shell.triangles[1].vertices, (std::array<Index, 3>{0, 3, 2}));
}

TEST(GivenMesh, IsRemeshedWhereAskedFor) {
    const Scene scene =
        parse_scene(sheet + "mesh = { given = \"kite\", remesh = 0.2 }\n", "a.toml", {}, kite());
    std::vector<std::string> warnings;
    EXPECT_GT(build_scene(scene, warnings).sheets.mechanics().triangles.size(), 30u);
}

TEST(GivenMesh, ThatNobodyGaveIsAnErrorOfItsLine) {
    const Scene scene = parse_scene(sheet + "mesh = { given = \"bowl\" }\n", "a.toml", {}, kite());
    std::vector<std::string> warnings;
    EXPECT_EQ(message_thrown_by([&] { build_scene(scene, warnings); }),
              "a.toml:5: sheet.kite.mesh: no program has passed a mesh of the name 'bowl': give a file "
              "instead, or pass the arrays with the scene");
}

}  // namespace
}  // namespace sherd::test
