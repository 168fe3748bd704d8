// SPDX-License-Identifier: GPL-3.0-or-later
// Comparisons of `sherd-bench paper`, `scaling` and `cracking`: if runs began differently, steps were counted
// twice, or ratios had wrong references, the tables of speed would be meaningless.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/bench/cost/paper_experiment.h"
#include "app/bench/cost/statistics.h"
#include "app/bench/cost/table_head.h"
#include "app/chart/chart_page.h"
#include "app/machine/memory.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

Scene small_plate(const std::vector<std::string>& settings) {
    return parse_scene(R"(duration = 1
[sheet.plate]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.02 }
clamp = { box = [[-1, -1, -1], [1e-6, 1, 1]] }
material = { preset = "glass", thickness = 0.001 }
velocity = [0, 0, 1]
[solver]
step = 1e-4
)",
                       "bench", {settings, ""});
}

TEST(TableHead, IsThatOfMarkdown) {
    EXPECT_EQ(table_head({"a", "b c"}), "| a | b c |\n| --- | --- |\n");
}

TEST(SpeedStatistics, AreThoseOfKnownNumbers) {
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 8}), 3);
    std::vector<Vector2d> points;
    for (const double x : {1.0, 4.0, 100.0}) points.emplace_back(x, 7 * std::pow(x, 1.25));
    EXPECT_NEAR(fitted_exponent(points), 1.25, 1e-12);
}

// Settings that a scene refuses, or whose reference comes later in the list, would end hours of measuring.
TEST(SolverChoices, AreReadAndStandBesideEarlierOnes) {
    const std::vector<SolverChoice> choices = solver_choices();
    std::set<std::string> names;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        EXPECT_TRUE(names.insert(choices[i].name).second) << choices[i].name;
        EXPECT_LE(place_beside(choices, i), i) << choices[i].name;
        EXPECT_NO_THROW(small_plate(choices[i].settings)) << choices[i].name;
        EXPECT_EQ(choices[i].is_coupled(), choices[place_beside(choices, i)].is_coupled());
    }
    for (const SolverChoice& choice : exact_choices(""))
        for (const std::string& setting : choice.settings)
            EXPECT_FALSE(setting.starts_with("solver.jacobian"));
    EXPECT_THROW(exact_choices("no such one"), Error);
}

TEST(Race, IsOfTheSameLapsForAll) {
    const std::string method = "solver.method=newton";  // makes a factorization in each iteration
    const std::vector<Scene> scenes{small_plate({"solver.bending=cubic", method}),
                                    small_plate({"solver.bending=cubic", method}),
                                    small_plate({"solver.bending=coupled", method})};
    // A large allowance, since laps of milliseconds may take several times as long on a busy machine.
    const std::vector<RaceResult> results =
        race(scenes, {.step = 1e-4, .settling = 2, .laps = 3, .allowance = 1e9});
    ASSERT_EQ(results.size(), 3u);
    for (const RaceResult& result : results) {
        EXPECT_TRUE(result.has_finished()) << result.failure;
        ASSERT_EQ(result.laps.size(), 3u);
        EXPECT_EQ(result.cost().steps, 3);
        EXPECT_NEAR(result.cost().simulated, 3e-4, 1e-12);
        EXPECT_GE(result.cost().factorizations, result.cost().iterations);
        EXPECT_EQ(result.cost().analyses, 0) << "the pattern is made in the laps before";
        EXPECT_GT(result.cost().seconds, 0);
    }
    EXPECT_EQ(results[0].end.position, results[1].end.position);
    EXPECT_GT((results[0].end.position - results[2].end.position).cwiseAbs().maxCoeff(), 0);
}

// A race that begins from the state of a run must continue this run. It is given positions and velocities
// only, and makes a factorization of its own, so that positions agree only within the tolerance.
TEST(Race, BeginsWhereItIsTold) {
    const Scene scene = small_plate({});
    MeasuredRun before(scene);
    before.advance_to(5e-4);
    const RaceResult later = race({scene}, {.step = 1e-4, .settling = 0, .laps = 2}, before.motion()).front();
    before.advance_to(7e-4);
    EXPECT_LE((later.end.position - before.motion().position).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT((before.motion().position - before.shell().rest).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(Race, EndsForOneThatTakesTooLong) {
    const Scene scene = small_plate({});
    const std::vector<RaceResult> results =
        race({scene, scene}, {.step = 1e-4, .settling = 0, .laps = 3, .allowance = 0});
    EXPECT_TRUE(results[0].has_finished()) << "the first one is never out";
    EXPECT_TRUE(results[1].is_out);
    EXPECT_LT(results[1].cost().steps, 3);
}

// The paper claims that the choice of the Jacobian changes the path to a minimum, but not the minimum.
TEST(PaperExperiment, OfOneEnergyEndsAtOnePlace) {
    std::vector<SolverChoice> choices = solver_choices();
    std::erase_if(choices, [](const SolverChoice& choice) { return choice.is_coupled(); });
    for (const PaperScene& scene : paper_scenes()) {
        if (scene.name == "flag") continue;  // buckles to one side or the other
        const std::vector<PaperResult> results = run_paper_case({scene, scene.steps.front(), 10, 3}, choices);
        ASSERT_EQ(results.size(), choices.size());
        for (std::size_t i = 0; i < results.size(); ++i) {
            EXPECT_TRUE(results[i].race.failure.empty()) << results[i].race.failure;
            EXPECT_GT(results[i].ratio, 0);
            // A race that took too long has no difference.
            EXPECT_FALSE(results[i].difference > 1e-4) << scene.name << " " << choices[i].name;
        }
        EXPECT_EQ(results.front().ratio, 1);
    }
}

TEST(MachineMemory, PeakIsOfWhatCameSinceItWasForgotten) {
    constexpr double size = 5e7;
    const auto hold = [] { return std::vector<char>(static_cast<std::size_t>(size), 1); };
    EXPECT_EQ(hold().back(), 1);
    const double before = peak_memory();
    reset_peak_memory();
    EXPECT_LE(peak_memory(), before);
    const std::vector<char> held = hold();
    EXPECT_GT(peak_memory(), resident_memory() - 0.1 * size);
    EXPECT_GT(resident_memory(), size);
    EXPECT_LT(resident_memory(), machine_memory());
    EXPECT_EQ(held.back(), 1);
}

/// Number of occurrences of `word` in `text`.
int times_in(const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

TEST(ChartPage, NamesLinesOnceWhereChartsShareThem) {
    const Chart chart{"title",
                      {.name = "x"},
                      {.name = "y"},
                      {{"first", "red", {{0, 1}, {1, 2}}}, {"second", "blue", {{0, 2}, {1, 3}}}}};
    ChartPage page{.heading = "above", .charts = {chart, chart, chart}, .columns = 3};
    EXPECT_EQ(times_in(page_svg(page), ">first<"), 3);
    page.shares_legend = true;
    EXPECT_EQ(times_in(page_svg(page), ">first<"), 1);
    EXPECT_EQ(times_in(page_svg(page), ">title<"), 3);
    EXPECT_EQ(times_in(page_svg(page), ">above<"), 1);
}

TEST(SpeedBench, DrawsAFigureWhereThereIsOne) {
    const TemporaryDirectory directory;
    const auto bench = [&](const std::vector<std::string>& arguments) {
        return run_program(SHERD_BENCH_PROGRAM, arguments, directory.path);
    };
    const std::vector<std::string> scaling{"scaling",  "--vertices", "1600",      "--only",
                                           "(CS, CS)", "-o",         "growth.svg"};
    const ProgramResult drawn = bench(scaling);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_NE(drawn.out.find("**Growth**"), std::string::npos) << drawn.out;
    EXPECT_NE(directory.contents().at(directory.path / "growth.svg").find("two passes, (CS, CS)"),
              std::string::npos);
    EXPECT_EQ(bench(scaling).exit_code, 2) << "there is a file of that name";
    const ProgramResult none = bench({"shells", "-o", "errors.svg"});
    EXPECT_EQ(none.exit_code, 2);
    EXPECT_NE(none.err.find("sherd-bench: error: -o: sherd-bench shells draws no figure"), std::string::npos)
        << none.err;
    const ProgramResult moved = run_sherd({"bench", "shells", "--quick"}, directory.path);
    EXPECT_EQ(moved.exit_code, 2);
    EXPECT_NE(moved.err.find("a program of its own: sherd-bench"), std::string::npos) << moved.err;
}

}  // namespace
}  // namespace sherd::test
