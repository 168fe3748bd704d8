// SPDX-License-Identifier: GPL-3.0-or-later
// `sherd modes`: output, recordings and errors. Otherwise users would take wrong frequencies for resonances.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <numbers>
#include <thread>

#include "app/recording/recording.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Json = nlohmann::json;

/// Square of side a = 0.1 m with rho t = 1 kg/m^2 and rigidity D = 1 N m, so that omega a^2 sqrt(rho t / D) =
/// omega / 100.
std::string square_plate(const std::string& more = "") {
    return "duration = 1\n[sheet.plate]\nmesh = { generate = \"rectangle\", width = 0.1, height = 0.1, "
           "edge_length = 0.005 }\nmaterial = { density = 1000, thickness = 1e-3, young = 10.92e9, poisson = "
           "0.3 }\n" +
           more + "[solver]\nbending = \"coupled\"\n";
}

class ModesCommand : public testing::Test {
  protected:
    ProgramResult modes(const std::string& scene, const std::vector<std::string>& arguments) {
        directory.write("scene.toml", scene);
        std::vector<std::string> all{"modes", "scene.toml"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        return run_sherd(all, directory.path);
    }
    Json json_of(const std::string& scene, std::vector<std::string> arguments = {}) {
        arguments.emplace_back("--json");
        const ProgramResult result = modes(scene, arguments);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return Json::parse(result.out);
    }

    TemporaryDirectory directory;
};

// With rho t = 1 kg/m^2, D = Y t^3 / (12 (1 - nu^2)) = 1 N m and a = 0.1 m, omega in 1/s is Leissa's number
// times 100.
TEST_F(ModesCommand, TellsTheFrequenciesOfAFreePlate) {
    const Json json = json_of(square_plate(), {"-n", "3"});
    EXPECT_EQ(json["rigid"], 6);
    EXPECT_EQ(json["free_coordinates"], 3 * json["vertices"].get<int>());
    ASSERT_EQ(json["modes"].size(), 3u);
    const std::vector<double> leissa{1346.8, 1959.6, 2427.0};
    for (int i = 0; i < 3; ++i) {
        const Json& mode = json["modes"][i];
        EXPECT_NEAR(mode["angular_frequency"].get<double>() / leissa[i], 1, 0.015);
        EXPECT_NEAR(mode["frequency"].get<double>() * 2 * std::numbers::pi, mode["angular_frequency"], 1e-9);
        EXPECT_EQ(mode["growth"], 0);
        EXPECT_NEAR(mode["out_of_plane"], 1, 1e-9);
    }
    const ProgramResult table = modes(square_plate(), {"-n", "3"});
    EXPECT_EQ(table.err, "");
    EXPECT_TRUE(contains(table.out, "6 rigid motions")) << table.out;
    EXPECT_TRUE(
        contains(table.out, fmt::format("   1 {:>14.5g}", json["modes"][0]["frequency"].get<double>())));
    EXPECT_FALSE(contains(table.out, "left out")) << table.out;
}

// Supports must act as in a run: if a support held too little, frequencies would be too low.
TEST_F(ModesCommand, HoldsWhatTheSceneHolds) {
    const auto first = [&](const std::string& supports, int rigid) {
        const Json json = json_of(square_plate(supports), {"-n", "1"});
        EXPECT_EQ(json["rigid"], rigid) << supports;
        return json["modes"][0]["angular_frequency"].get<double>() / 100;
    };
    const double pi = std::numbers::pi;
    EXPECT_NEAR(first("pin = { boundary = true }\n", 0), 2 * pi * pi, 0.2);
    EXPECT_NEAR(first("pin = { boundary = true, free = [\"x\", \"y\"] }\n", 3), 2 * pi * pi, 0.2);
    EXPECT_NEAR(first("clamp = { boundary = true }\n", 0), 35.985, 0.6);
    EXPECT_NEAR(first("clamp = { box = [[-1, -1, -1], [1e-6, 1, 1]] }\n", 0), 3.471, 0.05);
    // With two symmetry planes the square is a quarter of a simply supported plate of twice the side. Its
    // modes are the modes of this plate that are even in both directions; the first has a quarter of the
    // supported square's frequency.
    EXPECT_NEAR(
        first("pin = [{ box = [[0.0999, -1, -1], [1, 1, 1]] }, { box = [[-1, 0.0999, -1], [1, 1, 1]] }]\n"
              "symmetry = [{ point = [0, 0, 0], normal = [1, 0, 0] }, { point = [0, 0, 0], normal = "
              "[0, 1, 0] }]\n",
              0),
        pi * pi / 2, 0.1);
}

// Loads contribute their stiffness, at their full size. What modes leave out must be listed in the output.
TEST_F(ModesCommand, SaysWhatItLeavesOut) {
    const std::string more =
        "velocity = [0, 0, -1]\n[obstacle.floor]\nplane = { point = [0, 0, -1] }\n"
        "[obstacle.ball]\nsphere = { radius = 0.1, centre = [0, 0, 2] }\nmass = 1\n"
        "[force.wind]\nvelocity = [1, 0, 0]\n";
    const ProgramResult result = modes(square_plate(more) + "damping.mass = 1\n", {"-n", "1"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "left out     contact with floor, ball; wind; damping\n")) << result.out;
    const Json two = json_of(
        "duration = 1\n[sheet.a]\nmesh = { generate = \"disc\", radius = 0.1, edge_length = "
        "0.03 }\nmaterial = { preset = \"steel\" }\n[sheet.b]\nmesh = { generate = \"disc\", "
        "radius = 0.1, edge_length = 0.03 }\nplace = { translate = [0, 0, 1] }\nmaterial = { "
        "preset = \"steel\" }\n");
    EXPECT_EQ(two["rigid"], 12);
    EXPECT_EQ(two["left_out"], Json::array({"contact of the sheets with each other"}));
}

// An unstressed balloon is unstable under so large a pressure: the output must say so instead of giving a
// frequency.
TEST_F(ModesCommand, TellsOfAnUnstableState) {
    const std::string scene =
        "duration = 1\n[sheet.ball]\nmesh = { generate = \"sphere\", radius = 0.1, edge_length = 0.02 }\n"
        "material = { preset = \"steel\", thickness = 1e-3 }\n[[force.load]]\npressure = 1e10\nramp = 1\n";
    const ProgramResult result = modes(scene, {"-n", "2"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "   1  unstable: grows e-fold in ")) << result.out;
    EXPECT_TRUE(contains(result.err, "sherd: warning: the initial state of the scene is unstable"))
        << result.err;
    const Json json = json_of(scene, {"-n", "2", "-o", "collapse.h5"});
    EXPECT_EQ(json["modes"][0]["frequency"], 0);
    EXPECT_GT(json["modes"][0]["growth"], 100);
    const ProgramResult info = run_sherd({"info", "collapse.h5"}, directory.path);
    EXPECT_TRUE(contains(info.out, "     1  unstable, grows e-fold in ")) << info.out;
}

// Orthotropy and the other bending models must have an effect.
TEST_F(ModesCommand, FollowsMaterialAndModel) {
    const auto first = [&](const std::string& key) {
        return json_of(square_plate("clamp = { box = [[-1, -1, -1], [1e-6, 1, 1]] }\n"),
                       {"-n", "1", "--set", key})["modes"][0]["frequency"]
            .get<double>();
    };
    const double plain = first("seed=1");
    EXPECT_NEAR(first("solver.bending=cubic") / plain, 1, 0.1);
    EXPECT_NEAR(first("solver.bending=nonlinear") / plain, 1, 0.1);
    EXPECT_NE(first("solver.bending=cubic"), plain);
    EXPECT_NEAR(first("sheet.plate.material.young=[43.68e9, 10.92e9]") / plain, 2, 0.1);
    const double cubic = first("solver.bending=cubic");
    EXPECT_EQ(first("solver={bending=\"cubic\", jacobian=\"constant\"}"), cubic)
        << "a choice of Newton's method changes frequencies";
}

TEST_F(ModesCommand, RefusesWhatMakesNoSense) {
    for (const std::string count : {"0", "-3", "many", "1.5", "1001"}) {
        const ProgramResult result = modes(square_plate(), {"-n", count});
        EXPECT_EQ(result.exit_code, 2) << count;
        EXPECT_TRUE(contains(result.err, "--count")) << result.err;
    }
    EXPECT_EQ(modes(square_plate(), {"--amplitude", "0"}).exit_code, 2);
    const ProgramResult frames = modes(square_plate(), {"--frames", "6"});
    EXPECT_EQ(frames.exit_code, 2);
    EXPECT_TRUE(contains(frames.err, "is no multiple of 4: 6")) << frames.err;
    const ProgramResult held = modes(square_plate("pin = { box = [[-1, -1, -1], [1, 1, 1]] }\n"), {});
    EXPECT_EQ(held.exit_code, 2);
    EXPECT_TRUE(contains(held.err, "scene.toml: nothing can vibrate")) << held.err;
    const ProgramResult wrong = modes("duration = 1\n", {"-o", "modes.h5"});
    EXPECT_EQ(wrong.exit_code, 2);
    EXPECT_TRUE(contains(wrong.err, "scene.toml")) << wrong.err;
    EXPECT_FALSE(std::filesystem::exists(directory.path / "modes.h5"));
}

TEST_F(ModesCommand, GivesAllModesOfASmallMesh) {
    const std::string square =
        "duration = 1\n[sheet.a]\nmesh = { generate = \"rectangle\", width = 1, height = 1, edge_length = 1, "
        "structured = true }\nmaterial = { preset = \"steel\", thickness = 0.01 }\n";
    const ProgramResult result = modes(square, {"-n", "50"});
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(contains(result.out, "modes        all 6 that this mesh has")) << result.out;
}

// The recording must have the modes that are printed, and an existing recording must be kept.
TEST_F(ModesCommand, RecordsWhatItPrints) {
    const Json json =
        json_of(square_plate(), {"-n", "2", "-o", "modes.h5", "--frames", "4", "--amplitude", "0.2"});
    const Recording recording(directory.path / "modes.h5");
    const std::vector<RecordedMode> modes_read = recording.modes();
    ASSERT_EQ(modes_read.size(), 2u);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(modes_read[i].frequency, json["modes"][i]["frequency"]);
    ASSERT_EQ(recording.frame_count(), 9u);
    EXPECT_EQ(recording.end(), "complete");
    const Snapshot rest = recording.frame(0), largest = recording.frame(5), last = recording.frame(8);
    EXPECT_EQ(rest.position, recording.header().rest_position);
    EXPECT_EQ(largest.step, 2);
    EXPECT_EQ(largest.time, 1.25);
    EXPECT_EQ(last.time, 2);
    const double size = std::sqrt(2) * 0.1;
    EXPECT_NEAR((largest.position - rest.position).colwise().norm().maxCoeff(), 0.2 * size, 1e-9);
    EXPECT_GT(*std::max_element(largest.edge_strain.begin(), largest.edge_strain.end()), 1);
    const Json info = Json::parse(run_sherd({"info", "--json", "modes.h5"}, directory.path).out);
    EXPECT_EQ(info["modes"][1]["frequency"], json["modes"][1]["frequency"]);
    const auto before = directory.contents();
    const ProgramResult again = modes(square_plate(), {"-n", "2", "-o", "modes.h5"});
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_TRUE(contains(again.err, "'modes.h5'")) << again.err;
    EXPECT_EQ(again.out, "") << "the work is done before it is known to be in vain";
    EXPECT_EQ(directory.contents(), before);
}

// Commands that show runs must also show recorded modes, and name each mode.
TEST_F(ModesCommand, IsShownByWhatShowsRuns) {
    ASSERT_EQ(modes(square_plate(), {"-n", "2", "-o", "modes.h5", "--frames", "4"}).exit_code, 0);
    const auto works = [&](const std::vector<std::string>& arguments) {
        const ProgramResult result = run_sherd(arguments, directory.path);
        EXPECT_EQ(result.exit_code, 0) << arguments[0] << ": " << result.err;
    };
    works(
        {"render", "modes.h5", "-o", "pictures", "--frames", "1:8:4", "--samples", "1", "--size", "240x240"});
    EXPECT_TRUE(std::filesystem::exists(directory.path / "pictures/modes_000005.png"));
    works({"view", "modes.h5"});
    EXPECT_TRUE(contains(directory.contents()[(directory.path / "modes.html").string()], "mode 2: "));
    for (const std::string format : {"obj", "pvd", "glb", "mdd"})
        works({"export", "modes.h5", "--force", "--to", format});
    const ProgramResult plot = run_sherd({"plot", "modes.h5"}, directory.path);
    EXPECT_EQ(plot.exit_code, 2);
    EXPECT_TRUE(contains(plot.err, "modes of vibration")) << plot.err;
}

TEST_F(ModesCommand, TakesVariantsOneByOne) {
    const std::string scene = square_plate() +
                              "[[variant]]\nname = \"thin\"\nsheet.plate.material.thickness = 5e-4\n"
                              "[[variant]]\nname = \"thick\"\n";
    const Json both = json_of(scene, {"-n", "1", "-o", "m.h5", "--frames", "4"});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0]["variant"], "thin");
    EXPECT_NEAR(
        both[1]["modes"][0]["frequency"].get<double>() / both[0]["modes"][0]["frequency"].get<double>(), 2,
        0.01);
    EXPECT_TRUE(std::filesystem::exists(directory.path / "m-thin.h5"));
    EXPECT_TRUE(std::filesystem::exists(directory.path / "m-thick.h5"));
    EXPECT_EQ(json_of(scene, {"-n", "1", "--variant", "thick"})["variant"], "thick");
}

// Ctrl-C must leave a recording that can be read up to the interruption.
TEST_F(ModesCommand, CanBeInterrupted) {
    directory.write("scene.toml", square_plate());
    const std::filesystem::path file = directory.path / "modes.h5";
    const auto interrupt = [&](pid_t program) {
        for (int i = 0; i < 12000 && !std::filesystem::exists(file); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(program, SIGINT);
    };
    const ProgramResult result = run_sherd({"modes", "scene.toml", "-o", "modes.h5", "--frames", "1000"},
                                           directory.path, {}, interrupt);
    EXPECT_EQ(result.exit_code, 130);
    EXPECT_TRUE(contains(result.err, "interrupted")) << result.err;
    EXPECT_EQ(Recording(file).end(), "interrupted");
}

// A full disk must give an error, not a truncated recording.
TEST_F(ModesCommand, SaysThatTheDiskIsFull) {
    directory.write("scene.toml", square_plate());
    const ProgramResult result =
        run_sherd({"modes", "scene.toml", "-o", "modes.h5"}, directory.path, {.file_bytes = 1000000});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "sherd: error: cannot record")) << result.err;
}

}  // namespace
}  // namespace sherd::test
