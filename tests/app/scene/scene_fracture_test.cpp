// SPDX-License-Identifier: GPL-3.0-or-later
// The strength of a sheet must arrive as it was written: with a threshold in another unit everything would
// break, or nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/sheet/material_presets.h"
#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/scene_of.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

Scene breaking_plate(const std::string& fracture, const std::string& solver = "", int seed = 1) {
    const TemporaryDirectory directory;
    return read_scene(directory.write(
        "scene.toml",
        "duration = 0.0002\nseed = " + std::to_string(seed) +
            "\n[sheet.plate]\nmesh = { generate = \"disc\", radius = 0.1, edge_length = 0.03 }\n"
            "material = { preset = \"glass\" }\n[sheet.plate.fracture]\n" +
            fracture + "\n[solver]\n" + solver + "\n"));
}

const FractureSpec& fracture_of(const Scene& scene) {
    return *scene.sheets[0].fracture;
}

SheetInput input_of(const Scene& scene) {
    std::vector<std::string> warnings;
    return make_sheet(scene.sheets[0], scene, warnings);
}

TEST(SceneFracture, ValuesArriveWithTheirMeasure) {
    const Scene strain = breaking_plate("strain = 0.4\ncrack_tip = 1");
    EXPECT_EQ(fracture_of(strain).strength.measure, Measure::strain);
    EXPECT_EQ(fracture_of(strain).strength.across, 0.4);
    EXPECT_EQ(fracture_of(strain).strength.crack_tip_factor, 1);
    EXPECT_EQ(strain.simulation.rule, BreakingRule::staged);
    const Scene stress = breaking_plate("strength = [4e7, 1e7]");
    EXPECT_EQ(fracture_of(stress).strength.measure, Measure::stress);
    EXPECT_EQ(fracture_of(stress).strength.along, 4e7);
    EXPECT_EQ(fracture_of(stress).strength.across, 1e7);
    EXPECT_EQ(fracture_of(stress).strength.crack_tip_factor, 0.7) << "the default";
    const Scene paper = breaking_plate("strain = 0.4\nmeasure = \"bending\"", "rule = \"paper\"");
    EXPECT_EQ(fracture_of(paper).strength.measure, Measure::bending);
    EXPECT_EQ(paper.simulation.rule, BreakingRule::paper);
    std::vector<std::string> warnings;
    EXPECT_EQ(build_scene(paper, warnings).options.rule, BreakingRule::paper);
}

// Glass is isotropic, but its strength need not be.
TEST(SceneFracture, ADirectedStrengthGetsItsAxes) {
    const SheetInput input = input_of(breaking_plate("strength = [4e7, 1e7]"));
    EXPECT_EQ(input.axes.size(), input.mesh.number_of_faces());
    EXPECT_NO_THROW(BreakableShell({input}));
    EXPECT_TRUE(input_of(breaking_plate("strength = 4e7")).axes.empty());
}

TEST(SceneFracture, ScatterComesFromTheSeed) {
    const std::string weibull = "strain = 1\nweibull = 8";
    const std::vector<double> first = input_of(breaking_plate(weibull)).strength.factors;
    ASSERT_FALSE(first.empty());
    EXPECT_EQ(first, input_of(breaking_plate(weibull)).strength.factors);
    EXPECT_NE(first, input_of(breaking_plate(weibull, "", 2)).strength.factors);
    EXPECT_NE(first, input_of(breaking_plate(weibull + "\nweibull_area = 1e-4")).strength.factors);
    EXPECT_TRUE(input_of(breaking_plate("strain = 1")).strength.factors.empty());
}

struct BadFracture {
    std::string fracture, message;
};

class BadSceneFracture : public testing::TestWithParam<BadFracture> {};

TEST_P(BadSceneFracture, NamesTheKey) {
    try {
        breaking_plate(GetParam().fracture);
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos) << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(
    SceneFracture, BadSceneFracture,
    testing::Values(
        BadFracture{"", "fracture: needs strain (1/m) or strength (Pa)"},
        BadFracture{"strain = 1\nstrength = 1e7", "fracture.strength: conflicts with strain"},
        BadFracture{"strength = [1e7]", "fracture.strength: must be"},
        BadFracture{"strain = [1, -1]", "fracture.strain: must be"},
        BadFracture{"strength = 1e7\nmeasure = \"bending\"", "fracture.measure: \"bending\" is a strain"},
        BadFracture{"strain = 1\nmeasure = \"stress\"", "fracture.measure"},
        BadFracture{"strain = 1\ncrack_tip = 1.5",
                    "fracture.crack_tip: must be a number above 0, and 1 at most"},
        BadFracture{"strain = 1\nweibull = 0", "fracture.weibull: must be a positive number"},
        BadFracture{"strain = 1\nweibull_area = 1", "fracture.weibull_area: needs weibull"},
        BadFracture{"strain = 1\nwiebull = 3", "did you mean 'weibull'?"},
        BadFracture{"strength = 1e7\ntoughness = -1", "fracture.toughness: must be a positive number"},
        BadFracture{"strain = 1\ntoughness = 1e6", "fracture.toughness: needs strength (Pa)"},
        BadFracture{"strength = 1e7\ntoughness = 1e6\nfracture_energy = 8",
                    "fracture.fracture_energy: conflicts with toughness"},
        BadFracture{"strength = 1e7\ntoughness = 1e6\ncrack_tip = 1", "fracture.crack_tip: conflicts"},
        BadFracture{"strain = 1\nmeasure = \"bending\"\ntoughness = 1e6",
                    "fracture.toughness: needs strength"},
        BadFracture{"strength = 1e7\nmeasure = \"bending\"\ntoughness = 1e6", "\"bending\" is a strain"},
        BadFracture{"strength = 1e7\ntoughness = [1e6]", "fracture.toughness: must be"},
        BadFracture{"preset = true\nstrain = 1", "fracture.preset: conflicts with strain"},
        BadFracture{"preset = true\ncrack_tip = 1", "fracture.crack_tip: conflicts"},
        BadFracture{"preset = true\nmeasure = \"bending\"", "\"bending\" is a strain"},
        BadFracture{
            "strength = 1e7\nscore = { line = [[0, 0, 0], [1, 0, 0]], factor = 2, of = \"toughness\" }",
            "fracture.score.of: \"toughness\" needs fracture.toughness"},
        BadFracture{"strength = 1e7\nmap = { texture = \"a.png\", of = \"toughness\" }",
                    "fracture.map.of: \"toughness\" needs fracture.toughness"},
        BadFracture{"strength = 1e7\nmap = { texture = \"a.png\", of = \"age\" }",
                    "fracture.map.of: must be one of"},
        BadFracture{"strength = 1e7\nmap = { texture = \"a.png\", value = \"nver\" }",
                    "did you mean \"never\"?"},
        BadFracture{"strength = 1e7\nmap = { texture = \"a.png\", value = \"never\", range = [0, 1] }",
                    "fracture.map.range: conflicts with value"},
        BadFracture{"strength = 1e7\nafter = -1", "fracture.after: must be a number of 0 or more"},
        BadFracture{"strength = 1e7\nsmallest = 0", "fracture.smallest: must be a positive number"},
        BadFracture{"strength = 1e7\nspeed_limit = 400", "fracture.speed_limit: needs toughness"},
        BadFracture{"strength = 1e7\npath = \"edges\"", "fracture.path: needs toughness"},
        BadFracture{"strength = 1e7\ntoughness = 1e6\npath = \"x\"", "fracture.path"}));

// Without its toughness a sheet would break along paths that depend on the mesh.
TEST(SceneFracture, ToughnessArrivesWithItsSpeedLimit) {
    const SheetInput by_intensity = input_of(breaking_plate("strength = 4e7\ntoughness = 8e5"));
    EXPECT_EQ(by_intensity.toughness.value, 8e5);
    EXPECT_EQ(by_intensity.toughness.speed_limit, usual_speed_limit(by_intensity.material));
    const SheetInput by_energy =
        input_of(breaking_plate("strength = 4e7\nfracture_energy = 8\nspeed_limit = 900"));
    EXPECT_NEAR(by_energy.toughness.value, std::sqrt(8 * by_energy.material.young), 1e-6);
    EXPECT_EQ(by_energy.toughness.speed_limit, 900);
    EXPECT_EQ(by_energy.toughness.path, CrackPath::cut);
    EXPECT_EQ(input_of(breaking_plate("strength = 4e7\ntoughness = 1e6\npath = \"edges\"")).toughness.path,
              CrackPath::edges);
    EXPECT_FALSE(input_of(breaking_plate("strength = 4e7")).toughness.given());
    EXPECT_THROW(breaking_plate("strength = 4e7\ntoughness = 8e5", "rule = \"paper\""), Error);
    EXPECT_THROW(breaking_plate("strength = 4e7\nsmallest = 0.1", "rule = \"paper\""), Error);
}

// A toughness that depends on the direction needs the sheet's axes.
TEST(SceneFracture, ADirectedToughnessGetsItsAxes) {
    const SheetInput input = input_of(breaking_plate("strength = [4e7, 2e7]\ntoughness = [3e6, 1e6]"));
    EXPECT_EQ(input.toughness.value, 3e6);
    EXPECT_EQ(input.toughness.across, 1e6);
    EXPECT_EQ(input.axes.size(), input.mesh.number_of_faces());
    EXPECT_NO_THROW(BreakableShell({input}));
    EXPECT_FALSE(input_of(breaking_plate("strength = 4e7\ntoughness = 1e6")).toughness.has_directions());
}

TEST(SceneFracture, WhatIsKeptWholeForThePictureArrives) {
    const SheetInput input = input_of(breaking_plate("strength = 4e7\nafter = 0.01\nsmallest = 0.02"));
    EXPECT_EQ(input.art_direction.after, 0.01);
    EXPECT_EQ(input.art_direction.smallest, 0.02);
}

// A preset has the fracture data of its material, except for keys that are given.
TEST(SceneFracture, APresetBreaksLikeItsMaterialAndKeysWin) {
    const FractureSpec plain = fracture_of(breaking_plate("preset = true"));
    EXPECT_EQ(plain.strength.measure, Measure::stress);
    EXPECT_EQ(plain.strength.along, 6.5e7);
    EXPECT_EQ(plain.toughness, 7.5e5);
    EXPECT_EQ(plain.weibull_modulus, 7);
    EXPECT_EQ(plain.weibull_area, 0.07);
    EXPECT_EQ(plain.speed_limit, 1500);
    const FractureSpec given = fracture_of(breaking_plate(
        "preset = true\nstrength = 3e7\nfracture_energy = 8\nweibull = 20\nspeed_limit = 900"));
    EXPECT_EQ(given.strength.along, 3e7);
    EXPECT_EQ(given.toughness, 0);
    EXPECT_EQ(given.fracture_energy, 8);
    EXPECT_EQ(given.weibull_modulus, 20);
    EXPECT_EQ(given.weibull_area, 0.07);
    EXPECT_EQ(given.speed_limit, 900);
    EXPECT_EQ(fracture_of(breaking_plate("preset = false\nstrain = 1")).strength.along, 1);
}

TEST(SceneFracture, ATemperedSheetThatBreaksNeedsAToughness) {
    const std::string sheet = R"(duration = 1
[sheet.a]
mesh = { generate = "disc", radius = 0.2, edge_length = 0.05 }
material = { preset = "glass", tempered = 1e8 }
)";
    EXPECT_EQ(input_of(scene_of(sheet)).material.tempered, 1e8);
    EXPECT_THROW(scene_of(sheet + "fracture.strength = 4e7\n"), Error);
    const BreakableShell breaks(
        {input_of(scene_of(sheet + "fracture = { strength = 4e7, toughness = 7e5 }\n"))});
    for (const Edge edge : breaks.mesh().edges())
        EXPECT_TRUE(!breaks.can_fail(edge) || breaks.strength(edge) > 1.3e8);
}

// Each preset with fracture data must make a valid sheet, and presets without such data must be refused.
TEST(SceneFracture, EveryPresetMakesASheet) {
    for (const MaterialPreset& preset : material_presets()) {
        const std::string text =
            "duration = 1\n[sheet.a]\nmesh = { generate = \"disc\", radius = 0.2, "
            "edge_length = 0.05 }\nmaterial = { preset = \"" +
            std::string(preset.name) + "\" }\nfracture.preset = true\n";
        if (!preset.fracture) {
            EXPECT_THROW(scene_of(text), Error) << preset.name;
            continue;
        }
        const SheetInput input = input_of(scene_of(text));
        EXPECT_TRUE(input.toughness.given());
        EXPECT_GT(input.toughness.speed_limit, 100);
        EXPECT_LT(input.toughness.speed_limit, 2000) << preset.name;
        const BreakableShell sheet({input});
        for (const Edge edge : input.mesh.edges())
            EXPECT_EQ(sheet.toughness(edge).value > 0, sheet.hinge_of_edge(edge) >= 0);
    }
    EXPECT_THROW(
        scene_of("duration = 1\n[sheet.a]\nmesh = { generate = \"disc\", radius = 0.2, edge_length = "
                 "0.05 }\nmaterial = { density = 1, thickness = 1e-3, young = 1e9 }\n"
                 "fracture.preset = true\n"),
        Error);
}

// A crack of length 2 a = 60 mm in a sheet in tension must propagate straight from both tips when stress
// sqrt(pi a) reaches the toughness, within the error of the energy on so coarse a mesh.
TEST(SceneFracture, ACrackThatIsThereGrowsAtItsToughness) {
    const Scene scene = scene_of(R"(
[sheet.plate]
mesh = { generate = "rectangle", width = 0.4, height = 0.4, edge_length = 0.01 }
material = { preset = "glass" }
clamp = { box = [[-1, -1, -1], [0.0001, 1, 1]] }
[sheet.plate.fracture]
strength = 1e9
toughness = 1e6
crack = { line = [[0.2, 0.17, 0], [0.2, 0.23, 0]] }
[[force.load]]
line = [26000, 0, 0]
box = [[0.3999, -1, -1], [1, 1, 1]]
[contact]
sheets = false
[force]
)" + std::string("gravity = [0, 0, 0]\n[solver]\nscheme = \"static\"\nstep = 0.02\nuntil_crack = true\n"));
    std::vector<std::string> warnings;
    const BuiltScene built = build_scene(scene, warnings);
    ASSERT_GT(built.options.cracks.size(), 4u);
    Simulation simulation(built.sheets, built.options);
    double length = 0;
    for (const EdgeFailure& failure : simulation.take_events().failures) {
        EXPECT_EQ(failure.step, 0);
        length += (simulation.shell().mechanics().rest.col(failure.vertices[0]) -
                   simulation.shell().mechanics().rest.col(failure.vertices[1]))
                      .norm();
    }
    EXPECT_NEAR(length, 0.06, 1e-6) << "it is cut into the mesh";
    double load = 0;
    CrackEvents events;
    while (events.failures.empty() && load < 1) {
        load = simulation.step().load;
        events = simulation.take_events();
    }
    const double stress = 26000 / scene.sheets[0].material.thickness, half = 0.5 * length;
    EXPECT_NEAR(load * stress * std::sqrt(std::numbers::pi * half), 1e6, 0.1e6);
    EXPECT_GE(events.failures.size(), 1u);
    std::set<Index> ready;
    for (const TipRecord& tip : events.tips)
        if (tip.released > 0.9 * tip.toughness) ready.insert(tip.tip);
    EXPECT_EQ(ready.size(), 2u) << "it is as far at both tips when the first one goes on";
}

TEST(SceneFracture, ExplicitStepsHaveTheirOwnStepAndNoIterations) {
    const Scene scene = breaking_plate("strain = 1", "scheme = \"explicit\"");
    EXPECT_EQ(scene.simulation.stepper.scheme, Scheme::explicit_differences);
    EXPECT_EQ(scene.simulation.stepper.step, 2e-6);
    for (const char* key : {"tolerance = 1e-6", "max_iterations = 3", "max_stages = 3"})
        EXPECT_THROW(breaking_plate("strain = 1", std::string("scheme = \"explicit\"\n") + key), Error)
            << key;
}

TEST(SceneFracture, SchemesAreRead) {
    EXPECT_EQ(breaking_plate("strain = 1", "scheme = \"bdf2\"").simulation.stepper.scheme, Scheme::bdf2);
    const Scene by_turns = breaking_plate("strain = 1", "scheme = \"auto\"");
    EXPECT_TRUE(by_turns.simulation.alternates);
    EXPECT_EQ(by_turns.simulation.stepper.step, 1e-4) << "of implicit steps";
}

// An error on a retired key or choice must name its replacement.
TEST(SceneFracture, WhatThereIsNoMoreNamesItsSuccessor) {
    for (const auto& [line, instead] :
         std::map<std::string, std::string>{{"scheme = \"midpoint\"", "\"bdf2\""},
                                            {"adaptive = true", "scheme = \"auto\""},
                                            {"method = \"newton-2026\"", "\"newton\" "},
                                            {"bending = \"coupled-cubic\"", "\"coupled\""}}) {
        const std::string error = message_thrown_by([&line = line] { breaking_plate("strain = 1", line); });
        EXPECT_NE(error.find("any more: " + instead), std::string::npos) << error;
        EXPECT_NE(error.find("solver." + line.substr(0, line.find(' '))), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << "one error: " << error;
    }
}

}  // namespace
}  // namespace sherd::test
