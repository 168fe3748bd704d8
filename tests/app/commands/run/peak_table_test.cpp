// SPDX-License-Identifier: GPL-3.0-or-later
// Peaks of a run without fracture, and the thresholds at which it would have fractured.
#include "app/commands/run/peak_table.h"

#include <gtest/gtest.h>

#include <numeric>

#include "app/run/run_totals.h"
#include "app/run/runner.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

std::vector<double> one_to(int count) {
    std::vector<double> values(count);
    std::iota(values.begin(), values.end(), 1.0);
    return values;
}

TEST(PeakTable, QuantilesAreValuesThatHingesHave) {
    const std::vector<double> values = one_to(1000);
    EXPECT_EQ(peak_quantile(values, 0.5), 500);
    EXPECT_EQ(peak_quantile(values, 0.9), 900);
    EXPECT_EQ(peak_quantile(values, 0.999), 999);
    EXPECT_EQ(peak_quantile(values, 1), 1000);
    const std::vector<double> few{1, 2, 7};
    EXPECT_EQ(peak_quantile(few, 0.5), 2);
    EXPECT_EQ(peak_quantile(few, 0.99), 7);
    EXPECT_EQ(peak_quantile(std::vector<double>{3}, 0.5), 3);
}

TEST(PeakTable, ThresholdsAreRoundAndEachIsExceeded) {
    EXPECT_EQ(round_thresholds(one_to(1000)), (std::vector<double>{900})) << "99.9, 99 and 90 % round to one";
    std::vector<double> steep;
    for (int i = 0; i < 1000; ++i) steep.push_back(1e7 / (1000 - i));
    EXPECT_EQ(round_thresholds(steep), (std::vector<double>{5e6, 9e5, 9e4}));
    EXPECT_TRUE(round_thresholds(std::vector<double>(10, 0.0)).empty()) << "a sheet that is held everywhere";
    EXPECT_TRUE(round_thresholds(std::vector<double>(10, 200.0)).empty()) << "nothing is over 200";
}

TEST(PeakTable, CountsHingesOverThresholds) {
    std::vector<double> peaks = one_to(1000);
    const std::string table = peak_table(std::vector<PeakRow>{{"plate", "stress, Pa", peaks}});
    EXPECT_NE(table.find("peaks of hinges             50 %      90 %      99 %    99.9 %   largest\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("  plate stress, Pa           500       900       990       999     1e+03\n"),
              std::string::npos)
        << table;
    EXPECT_NE(table.find("of its 1000 hinges over 900: 100\n"), std::string::npos) << table;
}

/// The first steps of a stoneware disc that falls onto a floor at an angle, and the table of its peaks.
struct Dropped {
    Scene scene;
    RunTotals totals;
    std::vector<PeakRow> rows;

    explicit Dropped(const std::string& fracture) {
        scene = parse_scene(R"(duration = 2e-3
[sheet.disc]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { rotate = { axis = [1, 0.2, 0], degrees = 60 }, translate = [0, 0, 0.1] }
velocity = [0, 0, -10]
material.preset = "stoneware"
)" + fracture + "[obstacle.floor]\nplane = {}\n",
                            "scene.toml");
        std::vector<std::string> warnings;
        Runner runner(scene, build_scene(scene, warnings));
        runner.add(totals);
        for (int i = 0; i < 20; ++i) runner.step();
        rows = peak_rows(scene, runner.simulation());
    }
};

TEST(PeakTable, OfASheetThatCannotBreakHasStressAndStrain) {
    const Dropped dropped("");
    ASSERT_EQ(dropped.rows.size(), 2u);
    EXPECT_EQ(dropped.rows[0].measure, "stress, Pa");
    EXPECT_EQ(dropped.rows[0].peaks.back(), dropped.totals.peaks.peak_stress);
    EXPECT_EQ(dropped.rows[1].peaks.back(), dropped.totals.peaks.peak_strain);
    EXPECT_GT(dropped.rows[1].peaks.back(), 0);
}

// With scatter or directions each hinge breaks at its own multiple of the threshold: the table must give the
// threshold at which it would have broken.
TEST(PeakTable, CountsWhatEachHingeMakesOfTheThreshold) {
    for (const std::string fracture : {"strain = 1000", "strain = 1000\nmeasure = \"bending\"",
                                       "strength = [1e12, 3e12]\nweibull = 4", "strain = [2000, 1000]"}) {
        const Dropped dropped("[sheet.disc.fracture]\n" + fracture + "\n");
        ASSERT_EQ(dropped.totals.cracks, 0u);
        ASSERT_EQ(dropped.rows.size(), 1u) << fracture;
        const double threshold = dropped.scene.sheets[0].fracture->strength.along;
        const double overload = dropped.totals.peaks.peak_overload;
        EXPECT_GT(overload, 0);
        EXPECT_NEAR(dropped.rows[0].peaks.back() / threshold, overload, 1e-12 * overload) << fracture;
    }
    EXPECT_EQ(Dropped("[sheet.disc.fracture]\nstrain = 9\nmeasure = \"bending\"\n").rows[0].measure,
              "bending strain, 1/m");
}

// A tempered surface breaks where the stress exceeds the strength plus the compression. The table must give
// peaks less the compression, so that a user can compare them with `strength`.
TEST(PeakTable, LeavesOutTheCompressionOfATemperedSurface) {
    const std::string tough = "[sheet.disc.fracture]\nstrength = 1e12\ntoughness = 1e6\n";
    const Dropped plain(tough), tempered("material.tempered = 1e5\n" + tough);
    ASSERT_GT(plain.rows[0].peaks.back(), 1e5);
    EXPECT_NEAR(tempered.rows[0].peaks.back(), plain.rows[0].peaks.back() - 1e5,
                1e-6 * plain.rows[0].peaks.back());
}

const std::string falling_onto_floor = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place.translate = [0, 0, 0.0025]
velocity = [0, 0, -2]
material = { preset = "stoneware" }
[obstacle.floor]
plane = {}
[obstacle.ceiling]
plane = { point = [0, 0, 3], normal = [0, 0, -1] }
[obstacle.ball]
sphere = { radius = 0.1, centre = [1, 0, 2] }
mass = 1
)";

TEST(RunSummary, TellsPeaksWhenNothingBrokeAndWhatNothingTouched) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_onto_floor);
    const ProgramResult whole = run_sherd({"run", "scene.toml"}, directory.path);
    ASSERT_EQ(whole.exit_code, 0) << whole.err;
    for (const char* part : {"\npeaks of hinges", "\n  plate stress, Pa", "\n  plate strain, 1/m",
                             "\nnothing touched       obstacle.ceiling, obstacle.ball\n"})
        EXPECT_NE(whole.out.find(part), std::string::npos) << part << "\n" << whole.out;
    // Two triangles share a hinge with hardly any strength, which breaks in the first step on any machine.
    directory.write("square.obj", "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n");
    directory.write("scene.toml", R"(duration = 0.001
[sheet.square]
mesh = "square.obj"
spin = [30, 20, 0]
material = { preset = "stoneware" }
fracture = { strain = 1e-12 }
)");
    const ProgramResult broken = run_sherd({"run", "scene.toml", "--force"}, directory.path);
    ASSERT_EQ(broken.exit_code, 0) << broken.err;
    EXPECT_NE(broken.out.find("cracked edges         1\n"), std::string::npos) << broken.out;
    EXPECT_EQ(broken.out.find("peaks of hinges"), std::string::npos) << broken.out;
    EXPECT_EQ(broken.out.find("nothing touched"), std::string::npos) << broken.out;
}

// The summary must tell whether steel keeps its dent, or springs back because of the solver's options.
TEST(RunSummary, TellsWhereAMaterialIsBeyondItsYieldStress) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", R"(duration = 1e-4
[sheet.lid]
mesh = { generate = "rectangle", width = 0.1, height = 0.05, edge_length = 0.02 }
bend = { curvature = 10 }
material = { preset = "steel" }
[solver]
step = 5e-5
)");
    const ProgramResult run = run_sherd({"run", "scene.toml"}, directory.path);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    for (const char* part : {"\npeak yield            ", " times the yield stress, in sheet.lid at (",
                             "\nkeeps a dent          from 5e-05 s on\n"})
        EXPECT_NE(run.out.find(part), std::string::npos) << part << "\n" << run.out;
    const std::string warning = "times the yield stress, in sheet.lid at (",
                      other = "solver.bending=nonlinear";
    EXPECT_EQ(run_sherd({"check", "scene.toml"}, directory.path).out.find(warning), std::string::npos);
    const ProgramResult check = run_sherd({"check", "scene.toml", "--set", other}, directory.path);
    EXPECT_NE(check.out.find(warning), std::string::npos) << check.out;
    const ProgramResult elastic = run_sherd({"run", "scene.toml", "--force", "--set", other}, directory.path);
    EXPECT_NE(elastic.out.find("\nwould keep a dent     from 5e-05 s on; here it springs back\n"),
              std::string::npos)
        << elastic.out;
    const ProgramResult strong =
        run_sherd({"run", "scene.toml", "--force", "--set", "sheet.lid.material.yield=1e12"}, directory.path);
    EXPECT_NE(strong.out.find("peak yield"), std::string::npos) << strong.out;
    EXPECT_EQ(strong.out.find("a dent"), std::string::npos) << strong.out;
}

}  // namespace
}  // namespace sherd::test
