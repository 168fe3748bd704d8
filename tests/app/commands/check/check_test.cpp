// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of `sherd check` about scenes that can run, but are implausible.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/recording/recording.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/check/plausibility.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string disc = R"(duration = 0.03
[sheet.disc]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.02 }
place.translate = [0, 0, 0.05]
velocity = [0, 0, -2]
material = { preset = "stoneware" }
[obstacle.floor]
plane = {}
)";

/// Warnings about a scene's text, one in each line.
std::string warnings_of(const std::string& text, const SceneChoice& choice = {}) {
    const Scene scene = parse_scene(text, "scene.toml", choice);
    std::vector<std::string> ignored, warnings;
    const BuiltScene built = build_scene(scene, ignored);
    warn_of_implausible(scene, built.inputs, built.options, warnings);
    std::string lines;
    for (const std::string& warning : warnings) lines += warning + "\n";
    return lines;
}

std::string with(const std::vector<std::string>& overrides) {
    return warnings_of(disc, {overrides, ""});
}

TEST(Plausibility, SaysNothingOfWhatIsMeant) {
    EXPECT_EQ(with({}), "");
    EXPECT_EQ(with({"sheet.disc.fracture.strength=6e7"}), "");
    EXPECT_EQ(with({"sheet.disc.fracture.strain=0.4"}), "");
    EXPECT_EQ(with({"sheet.disc.material.thickness=1e-4"}), "") << "paper";
    EXPECT_EQ(with({"sheet.disc.fracture.strength=2e7", "sheet.disc.material.young=2e6"}), "") << "rubber";
}

// Numbers in GPa or g/cm^3 give another material, far too soft or too light.
TEST(Plausibility, AMaterialInOtherUnitsIsTold) {
    EXPECT_NE(with({"sheet.disc.material.young=70"}).find("so slow; young is in Pa"), std::string::npos);
    EXPECT_NE(with({"sheet.disc.material.density=2.4"}).find("so fast; young is in Pa"), std::string::npos);
}

// If the step is too long to resolve a peak of the strain, a sheet seems not to fracture.
TEST(Plausibility, AStepThatIsLongForTheSlowestVibrationIsTold) {
    EXPECT_EQ(with({"sheet.disc.fracture.strain=0.4", "solver.step=1.7e-4"}), "");
    EXPECT_NE(with({"sheet.disc.fracture.strain=0.4", "solver.step=2e-4"}).find("long even for"),
              std::string::npos);
    EXPECT_EQ(with({"solver.step=2e-4"}), "") << "what cannot break";
}

TEST(Plausibility, MeshesThatWereNeverScaledAreTold) {
    const std::string large = with({"sheet.disc.mesh.radius=10", "sheet.disc.mesh.edge_length=2"});
    EXPECT_TRUE(contains(large, "scene.toml:3: sheet.disc.mesh: sheet.disc is 28.")) << large;
    EXPECT_TRUE(contains(large, " times its thickness; lengths are in m\n")) << large;
    const std::string small = with({"sheet.disc.mesh.radius=0.006", "sheet.disc.mesh.edge_length=0.006"});
    EXPECT_TRUE(contains(small, "0.004 m thick, 4 times its thickness; lengths")) << small;
    const TemporaryDirectory directory;
    directory.write("bowl.obj", "v 0 0 5\nv 8 0 5\nv 8 8 5\nv 0 8 5\nf 1 2 3\nf 1 3 4\n");
    directory.write("scene.toml", R"(duration = 0.03
[sheet.bowl]
mesh = "bowl.obj"
material = { preset = "porcelain" }
)");
    const ProgramResult file = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(file.exit_code, 0);
    EXPECT_TRUE(contains(file.out, "a mesh modelled in centimetres needs scale = 0.01")) << file.out;
    const ProgramResult scaled = run_sherd(
        {"check", "scene.toml", "--set", "sheet.bowl.mesh={file='bowl.obj',scale=0.01}"}, directory.path);
    EXPECT_FALSE(contains(scaled.out, "warning")) << scaled.out;
}

// Cracks have no path in a sheet of one polygon, and a user would take the result for a prediction.
TEST(Plausibility, MeshesTooCoarseToBreakAreTold) {
    const TemporaryDirectory directory;
    directory.write("square.obj", "v 0 0 0\nv 0.2 0 0\nv 0.2 0.2 0\nv 0 0.2 0\nf 1 2 3 4\n");
    const auto said = [&](const std::string& mesh, const std::string& fracture) {
        directory.write("scene.toml", "duration = 1e-4\n[sheet.plate]\nmesh = { file = \"square.obj\"" +
                                          mesh + " }\nmaterial = { preset = \"glass\" }\n" + fracture);
        return run_sherd({"check", "scene.toml", "--no-try"}, directory.path).out;
    };
    const std::string breaking = "fracture = { preset = true }\n";
    EXPECT_TRUE(
        contains(said("", breaking), "the longest edge of sheet.plate is 0.28 m, in a sheet 0.28 m large"));
    EXPECT_TRUE(contains(said("", breaking), "add remesh = 0.008 to its mesh"));
    EXPECT_FALSE(contains(said(", remesh = 0.02", breaking), "longest edge"));
    EXPECT_FALSE(contains(said("", ""), "longest edge")) << "what does not break";
}

TEST(Plausibility, StrengthsInTheWrongUnitAreTold) {
    for (const char* wrong : {"strength=60", "strength=[60,30]", "strain=4e-4"}) {
        const std::string weak = with({std::string("sheet.disc.fracture.") + wrong});
        EXPECT_TRUE(contains(weak, "no material is so weak")) << wrong << weak;
    }
    for (const char* wrong : {"strength=6e10", "strain=200"}) {
        const std::string strong = with({std::string("sheet.disc.fracture.") + wrong});
        EXPECT_TRUE(contains(strong, "no such material is so strong")) << wrong << strong;
    }
}

// If the check compared the mean edge, it would miss a part of the mesh that is too fine.
TEST(Plausibility, EdgesShorterThanTheThicknessAreTold) {
    const TemporaryDirectory directory;
    std::string strip;
    for (const double x : {0.0, 0.02, 0.04, 0.06, 0.062, 0.082, 0.102})
        for (const double y : {0.0, 0.02, 0.04})
            strip += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
    for (int column = 0; column < 6; ++column)
        for (const int v : {3 * column + 1, 3 * column + 2})
            strip += "f " + std::to_string(v) + " " + std::to_string(v + 3) + " " + std::to_string(v + 4) +
                     " " + std::to_string(v + 1) + "\n";
    directory.write("strip.obj", strip);
    directory.write("scene.toml",
                    "duration = 1\n[sheet.strip]\nmesh = \"strip.obj\"\nmaterial = { preset = \"glass\" }\n");
    const ProgramResult thick = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(thick.exit_code, 0) << thick.err;
    EXPECT_TRUE(contains(thick.out, " edges of sheet.strip are shorter than it is thick (0.004 m)"))
        << thick.out;
    EXPECT_TRUE(contains(thick.out, "where the sheet bends, make them longer")) << "in plane they may stay";
    const ProgramResult thin =
        run_sherd({"check", "scene.toml", "--set", "sheet.strip.material.thickness=0.001"}, directory.path);
    EXPECT_FALSE(contains(thin.out, "shorter than it is thick")) << thin.out;
}

// Far from the origin positions are rounded so coarsely that Newton's corrections never become small enough,
// and a user would blame the tolerance.
TEST(Plausibility, PlacesWhereDigitsRunOutAreTold) {
    EXPECT_EQ(with({"sheet.disc.place.translate=[1e5, 0, 0.05]"}), "");
    EXPECT_NE(with({"sheet.disc.place.translate=[1e9, 0, 0.05]", "obstacle={}"})
                  .find("is 1e+09 m from the origin, where positions are rounded to 2e-07 m"),
              std::string::npos);
}

TEST(Plausibility, WhatGoesTooFarInAStepIsTold) {
    const std::string fast = with({"sheet.disc.velocity=[0,0,-500]"});
    EXPECT_TRUE(
        contains(fast, "sheet.disc comes 0.05 m nearer to what it hits in one solver.step of 0.0001 s"))
        << fast;
    EXPECT_TRUE(contains(fast, "use a step of 4e-05 s or less") ||
                contains(fast, "use a step of 3e-05 s or less"))
        << fast;
}

TEST(Plausibility, ObstaclesOutOfReachAreTold) {
    const std::string slow = with({"sheet.disc.velocity=[0,0,0]"});
    EXPECT_TRUE(
        contains(slow, "scene.toml:8: obstacle.floor.plane: nothing can reach obstacle.floor in 0.03 s"))
        << slow;
    EXPECT_EQ(with({"sheet.disc.velocity=[0,0,0]", "duration=0.2"}), "") << "it falls";
    EXPECT_TRUE(contains(with({"sheet.disc.velocity=[0,0,2]"}), "nothing can reach")) << "upwards";
    const std::string ball = "obstacle.ball={sphere={radius=0.01,centre=[0.5,0,0.02]},";
    EXPECT_TRUE(contains(with({ball + "mass=1}", "duration=0.01"}), "nothing can reach obstacle.ball"));
    EXPECT_EQ(with({ball + "mass=1,velocity=[-60,0,0]}", "duration=0.02"}), "") << "it comes";
    EXPECT_EQ(with({ball + "keys=[{time=0},{time=0.02,translate=[-0.4,0,0]}]}", "duration=0.02"}), "")
        << "it is moved there";
    EXPECT_TRUE(contains(with({ball + "keys=[{time=0},{time=0.02,translate=[0.4,0,0]}]}", "duration=0.01"}),
                         "nothing can reach obstacle.ball"));
    // No warning is given about sheets after a collision, with supports or in wind: they may go anywhere.
    const std::string wall = "obstacle.wall={plane={point=[-0.15,0,0],normal=[1,0,0]}}";
    EXPECT_TRUE(contains(with({wall, "duration=0.02"}), "nothing can reach obstacle.wall"));
    EXPECT_EQ(with({wall, "duration=0.2"}), "") << "shards fly";
    const std::string hanging = "sheet.disc.pin={box=[[-1,-1,-1],[0,1,1]]}";
    EXPECT_EQ(with({hanging, "duration=0.2"}), "") << "it swings";
    EXPECT_EQ(with({"sheet.disc.velocity=[0,0,0]", "force.gravity=[0,0,0]", "force.load={pressure=-1e4}"}),
              "");
    EXPECT_EQ(
        with({"sheet.disc.velocity=[0,0,0]", "force.gravity=[0,0,0]", "force.wind={velocity=[0,0,-9]}"}), "");
}

// A membrane that locks makes a curved sheet too stiff and its stress wrong, without any other sign.
TEST(Plausibility, CoarseCurvedSheetsThatLockAreTold) {
    const auto tube = [](const std::vector<std::string>& overrides) {
        std::vector<std::string> all{
            "sheet.disc.mesh={generate='cylinder',radius=0.1,height=0.2,edge_length=0.03}",
            "sheet.disc.material.thickness=0.001"};
        all.insert(all.end(), overrides.begin(), overrides.end());
        return with(all);
    };
    const std::string locks = tube({});
    EXPECT_TRUE(contains(locks, ": sheet.disc.mesh: ")) << locks;
    EXPECT_TRUE(contains(locks, " faces of sheet.disc have edges so long for its radius and thickness"))
        << locks;
    EXPECT_TRUE(contains(locks, "use solver.membrane = \"arc\", or edges of 0.01")) << locks;
    EXPECT_EQ(tube({"solver.membrane=arc"}), "");
    EXPECT_EQ(tube({"sheet.disc.mesh.edge_length=0.012"}), "");
    EXPECT_EQ(tube({"sheet.disc.material.thickness=0.005"}), "");
}

// Users would ignore warnings if shipped scenes had wrong ones.
class ShippedScene : public testing::TestWithParam<std::string> {};

TEST_P(ShippedScene, HasNothingImplausible) {
    const std::filesystem::path file = std::filesystem::path(SHERD_SCENES) / (GetParam() + ".toml");
    std::vector<std::string> variants = variant_names(read_scene_text(file), file);
    if (variants.empty()) variants.push_back("");
    for (const std::string& variant : variants) {
        const Scene scene = read_scene(file, {{}, variant});
        std::vector<std::string> ignored, warnings;
        const BuiltScene built = build_scene(scene, ignored);
        warn_of_implausible(scene, built.inputs, built.options, warnings);
        EXPECT_EQ(warnings, std::vector<std::string>{}) << variant;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Scene, ShippedScene,
    testing::Values("bowl_drop", "bowl_on_anvil", "crumple", "drape", "hinged_roof", "plate_drop",
                    "plate_stack", "shards_in_box", "sheet_hang", "window_ball", "wine_glass",
                    "experiments/bent_plate", "experiments/branching", "experiments/burst_egg",
                    "experiments/centre_crack", "experiments/double_cantilever", "experiments/dropped_bowl",
                    "experiments/dropped_sphere", "experiments/dropped_wine_glass", "experiments/edge_notch",
                    "experiments/glass_tube", "experiments/offset_hole", "experiments/released_strip",
                    "experiments/spaghetti", "experiments/struck_plate", "experiments/torn_flap",
                    "paper/figure_3_cylinders", "paper/figure_4_poncho", "paper/figure_5_flags",
                    "paper/figure_6_plates", "paper/figure_7_bowls", "paper/section_8_cylinder",
                    "paper/section_8_flag"),
    [](const auto& info) {
        std::string name = info.param;
        std::replace(name.begin(), name.end(), '/', '_');
        return name;
    });

// The check tests all sheets together, but its message must name the sheet that has the fault.
TEST(Check, NamesTheSheetThatDoesNotHoldItsShape) {
    const TemporaryDirectory directory;
    const auto sheet = [](const std::string& name, const std::string& height, const std::string& thickness) {
        return "[sheet." + name +
               "]\nmesh = { generate = \"cylinder\", radius = 0.1, height = 0.1, edge_length = 0.03 }\n"
               "place.translate = [0, 0, " +
               height +
               "]\nmaterial = { density = 1000, young = 1e9, poisson = 0.3, thickness = " + thickness +
               " }\n";
    };
    const auto errors_of = [&](const std::string& command, const std::string& second) {
        directory.write("scene.toml", "duration = 1e-4\n" + sheet("thin", "0", "1e-3") +
                                          sheet("other", "50", second) + "[solver]\nbending = \"cubic\"\n");
        return run_sherd({command, "scene.toml"}, directory.path);
    };
    for (const std::string command : {"check", "run"}) {
        const ProgramResult thick = errors_of(command, "5");
        EXPECT_EQ(thick.exit_code, 2) << thick.err;
        EXPECT_NE(
            thick.err.find("scene.toml:7: sheet.other.mesh: a sheet 5 m thick does not hold this shape"),
            std::string::npos)
            << thick.err;
        EXPECT_EQ(thick.err.find("sheet.thin"), std::string::npos) << thick.err;
    }
    EXPECT_EQ(errors_of("check", "1e-3").exit_code, 0);
}

TEST(Check, TellsWhatARunWillTake) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", disc);
    const ProgramResult tried = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(tried.exit_code, 0) << tried.err;
    EXPECT_TRUE(contains(tried.out, "will take 300 steps, 101 frames, a recording of about ")) << tried.out;
    EXPECT_TRUE(contains(tried.out, "will take about ") &&
                contains(tried.out, " on this machine, estimated from the first steps"))
        << tried.out;
    const ProgramResult untried = run_sherd({"check", "scene.toml", "--no-try"}, directory.path);
    EXPECT_TRUE(contains(untried.out, "will take 300 steps")) << untried.out;
    EXPECT_FALSE(contains(untried.out, "first steps")) << untried.out;
    EXPECT_EQ(directory.contents().size(), 1u) << "nothing is written";
}

// The number of frames in the estimate must be that of the run, whatever the interval between frames.
TEST(Check, FramesAndSizeAreThoseOfTheRun) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", disc);
    for (const char* every : {"1e-4", "1.5e-4", "7e-4", "1e-3", "1"}) {
        const std::vector<std::string> choice{"--set", "duration=0.0032", "--set",
                                              std::string("output.every=") + every};
        std::vector<std::string> run{"run", "scene.toml", "--force"};
        run.insert(run.end(), choice.begin(), choice.end());
        ASSERT_EQ(run_sherd(run, directory.path).exit_code, 0);
        const Scene scene = read_scene(directory.path / "scene.toml", {{choice[1], choice[3]}, ""});
        EXPECT_EQ(static_cast<std::int64_t>(Recording(directory.path / "scene.h5").frame_count()),
                  frame_count(scene))
            << every;
    }
}

// A pane of 1 m bears its weight at rest, with a stress of 2.4 MPa and a strength of 3 MPa, but fractures
// when the weight is applied at once.
TEST(Check, TellsThatWeightAloneBreaksAPane) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", R"(duration = 0.06
[sheet.pane]
mesh = { generate = "rectangle", width = 1, height = 1, edge_length = 0.06 }
material = { preset = "glass", thickness = 0.003 }
pin = { boundary = true }
)");
    const auto words_of = [&](const std::string& strength) {
        return run_sherd({"check", "scene.toml", "--set", "sheet.pane.fracture.strength=" + strength},
                         directory.path)
            .out;
    };
    const std::string weak = words_of("3e6");
    EXPECT_TRUE(contains(weak, "the weight of sheet.pane alone takes 0.")) << weak;
    EXPECT_TRUE(contains(weak, "area = [0, 0, -73.6], ramp = ")) << weak;
    const std::string weaker = words_of("1e6");
    EXPECT_TRUE(contains(weaker, "the weight of sheet.pane alone takes 2")) << weaker;
    EXPECT_FALSE(contains(words_of("3e7"), "the weight of")) << "a tenth of it is safe";
}

TEST(Check, WarnsOfMoreThanADay) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", disc);
    const std::vector<std::string> long_run{"check",        "scene.toml", "--set",
                                            "duration=1e3", "--set",      "solver.step=1e-6"};
    const ProgramResult result = run_sherd(long_run, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "warning: scene.toml: will take more than a day, about ")) << result.out;
}

// Above a screen full of sheets and variants, a user would overlook warnings and mistakes.
TEST(Check, WarningsAndMistakesComeLast) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", disc + R"(
[[variant]]
name = "weak"
sheet.disc.fracture.strength = 60
[[variant]]
name = "far"
sheet.disc.velocity = [0, 0, 0]
[[variant]]
name = "stuck"
sheet.disc.pin = { box = [[5, 5, 5], [6, 6, 6]] }
)");
    const ProgramResult result = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "holds no vertex") && contains(result.err, "(variant stuck)"))
        << result.err;
    const std::size_t last = result.out.rfind("\nvariant stuck\n"),
                      first_warning = result.out.find("\nwarning: ");
    ASSERT_NE(last, std::string::npos) << result.out;
    ASSERT_NE(first_warning, std::string::npos) << result.out;
    EXPECT_LT(last, first_warning) << result.out;
    const std::string end = result.out.substr(first_warning + 1);
    EXPECT_EQ(std::count(end.begin(), end.end(), '\n'), 2) << end;
    EXPECT_TRUE(contains(end, "so weak") && contains(end, "(variant weak)\n")) << end;
    EXPECT_TRUE(contains(end, "nothing can reach") && contains(end, "(variant far)\n")) << end;
}

}  // namespace
}  // namespace sherd::test
