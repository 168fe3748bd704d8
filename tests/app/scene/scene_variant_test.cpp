// SPDX-License-Identifier: GPL-3.0-or-later
// If a variant changed more or less than its keys, a comparison of variants would be worthless.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/program.h"
#include "tests/support/program/scene_of.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string tube = R"(duration = 0.5
[sheet.tube]
mesh = { generate = "cylinder", radius = 0.1, height = 0.3, edge_length = 0.05 }
place = { translate = [0, 0, 1] }
material = { preset = "cotton" }
[[force.load]]
area = [0, 0, 1]
[[force.load]]
area = [0, 0, 2]
)";
const std::string variants = R"([[variant]]
name = "vertical"
sheet.tube.material.axis.degrees = 90
solver.step = 2e-4
[[variant]]
name = "loaded-2"
seed = 5
sheet.tube.mesh = { generate = "disc", radius = 0.2, edge_length = 0.1 }
[[variant.force.load]]
area = [3, 0, 0]
[variant.obstacle.floor]
plane = { normal = [0, 0, 1] }
)";

std::string variant_message(const std::string& text, const SceneChoice& choice = {}) {
    return message_thrown_by([&] { scene_of(text, choice); });
}

TEST(SceneVariant, ChangesItsKeysAndNothingElse) {
    const Scene plain = scene_of(tube + variants);
    EXPECT_EQ(plain.loads.size(), 2u);
    EXPECT_EQ(plain.simulation.stepper.step, 1e-4);
    EXPECT_TRUE(plain.obstacles.empty());
    EXPECT_EQ(plain.variant, "");

    const Scene vertical = scene_of(tube + variants, {{}, "vertical"});
    EXPECT_EQ(vertical.variant, "vertical");
    EXPECT_EQ(std::get<AxisDirection>(vertical.sheets[0].axis.kind).degrees, 90);
    EXPECT_EQ(vertical.simulation.stepper.step, 2e-4);
    EXPECT_EQ(vertical.sheets[0].material.density, plain.sheets[0].material.density) << "preset was lost";
    EXPECT_EQ(vertical.loads.size(), 2u);

    const Scene loaded = scene_of(tube + variants, {{}, "loaded-2"});
    EXPECT_EQ(loaded.seed, 5);
    ASSERT_EQ(loaded.loads.size(), 1u) << "arrays are replaced as a whole";
    EXPECT_EQ(loaded.loads[0].force, Vector3d(3, 0, 0));
    EXPECT_EQ(loaded.sheets[0].place.translation(), Vector3d(0, 0, 1));
    ASSERT_EQ(loaded.obstacles.size(), 1u);
    EXPECT_EQ(loaded.obstacles[0].name, "floor");
}

TEST(SceneVariant, OverridesWinAndTheTextSaysWhatWasRun) {
    const std::vector<std::string> overrides{"solver.step=1e-3", "seed=9"};
    const Scene scene = scene_of(tube + variants, {overrides, "vertical"});
    EXPECT_EQ(scene.simulation.stepper.step, 1e-3);
    EXPECT_EQ(scene.text,
              tube + variants + "# --variant vertical\n# --set solver.step=1e-3\n# --set seed=9\n");
    const SceneChoice choice = recorded_choice(scene.text);
    EXPECT_EQ(choice.variant, "vertical");
    EXPECT_EQ(choice.overrides, overrides);
    EXPECT_EQ(scene_of(scene.text, choice).seed, 9);
    EXPECT_EQ(scene_of(tube).text, tube);
}

// Lines 10 to 12 of these scenes belong to the variant.
TEST(SceneVariant, MistakesAreToldWhereTheyStand) {
    const auto mistake = [](const std::string& lines) {
        return variant_message(tube + "[[variant]]\nname = \"a\"\n" + lines, {{}, "a"});
    };
    const auto says = [](const std::string& message, const std::string& wanted) {
        EXPECT_NE(message.find("scene.toml:" + wanted), std::string::npos) << message;
    };
    says(mistake("solver.stpe = 1\n"), "12: solver.stpe: unknown key; did you mean 'step'?");
    says(mistake("sheet.tube.material.thickness = 0\n"),
         "12: sheet.tube.material.thickness: must be a positive");
    says(mistake("variant.name = \"b\"\n"), "12: variant: belongs at the top level of the scene");
    says(mistake("[[variant]]\nseed = 3\n"), "12: variant[1].name: is missing");
    says(mistake("[[variant]]\nname = \"a\"\n"), "13: variant[1].name: \"a\" is the name of another variant");
    says(mistake("[[variant]]\nname = \"a/b\"\n"), "13: variant[1].name: becomes a part of a file's name");
    says(variant_message(tube + "[[varaint]]\n"), "10: varaint: unknown key; did you mean 'variant'?");
    EXPECT_NE(variant_message(tube, {{"variant.name=a"}, ""})
                  .find("--set variant.name=a: variant: belongs at the top level"),
              std::string::npos);
}

// If a variant without a valid name hid other mistakes, a user would find them one after the other.
TEST(SceneVariant, OneWithoutANameHidesNoOtherMistake) {
    const auto mistakes = [](const std::string& lines) {
        return message_thrown_by([&] { parse_scenes("sed = 1\n" + tube + lines, "scene.toml", {}); });
    };
    const auto says = [](const std::string& message, const std::string& wanted) {
        EXPECT_NE(message.find(wanted), std::string::npos) << message;
    };
    const std::string typo = mistakes("[[variant]]\nnme = \"a\"\nsolver.stpe = 1\n" + variants);
    says(typo, "scene.toml:1: sed: unknown key; did you mean 'seed'?");
    says(typo, "scene.toml:11: variant[0].name: is missing");
    says(typo, "scene.toml:12: variant[0].nme: unknown key; did you mean 'name'?");
    says(typo, "scene.toml:13: solver.stpe: unknown key; did you mean 'step'?");
    says(typo, "(variant number 1)");
    EXPECT_EQ(std::count(typo.begin(), typo.end(), '\n'), 3) << "each mistake once: " << typo;
    const std::string wrong = mistakes("[[variant]]\nname = \"a b\"\nsolver.stpe = 1\n");
    says(wrong, "variant[0].name: becomes a part of a file's name");
    says(wrong, "scene.toml:13: solver.stpe: unknown key");
    says(wrong, "scene.toml:1: sed: unknown key");
}

TEST(SceneVariant, AnUnknownOneIsToldThoseThatThereAre) {
    const std::string message = variant_message(tube + variants, {{}, "vertica"});
    EXPECT_NE(message.find("did you mean 'vertical'? it has: vertical, loaded-2"), std::string::npos)
        << message;
    EXPECT_NE(variant_message(tube, {{}, "a"}).find("has no variants at all"), std::string::npos);
    const TemporaryDirectory directory;
    directory.write("scene.toml", tube + variants);
    for (const std::string command : {"run", "check"})
        EXPECT_EQ(run_sherd({command, "scene.toml", "--variant", "c"}, directory.path).exit_code, 2);
    EXPECT_EQ(directory.contents().size(), 1u);
}

TEST(SceneVariant, CheckLooksAtAllAndTellsWhatTheyShareOnce) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", tube + variants);
    const ProgramResult good = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(good.out.find("variant vertical\n"), std::string::npos);
    EXPECT_NE(good.out.find("variant loaded-2\n"), std::string::npos);
    const ProgramResult one = run_sherd({"check", "scene.toml", "--variant", "vertical"}, directory.path);
    EXPECT_EQ(one.out.find("loaded-2"), std::string::npos);
    EXPECT_NE(one.out.find("2500 steps"), std::string::npos) << one.out;

    const std::string stuck =
        "[[variant]]\nname = \"stuck\"\nsheet.tube.pin = { box = [[5, 5, 5], [6, 6, 6]] }\n";
    directory.write("scene.toml", tube + variants + stuck);
    const ProgramResult mesh = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(mesh.exit_code, 2);
    EXPECT_NE(mesh.err.find("scene.toml:24: sheet.tube.pin: holds no vertex"), std::string::npos) << mesh.err;
    EXPECT_NE(mesh.err.find("(variant stuck)"), std::string::npos) << mesh.err;

    directory.write("scene.toml", "sed = 1\n" + tube + variants + stuck);
    const ProgramResult shared = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(std::count(shared.err.begin(), shared.err.end(), '\n'), 1) << shared.err;
    EXPECT_NE(shared.err.find("scene.toml:1: sed: unknown key"), std::string::npos) << shared.err;
}

}  // namespace
}  // namespace sherd::test
