// SPDX-License-Identifier: GPL-3.0-or-later
// How runs end, and what they say then, through the real program.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/recording/recording.h"
#include "tests/support/program/edited_file.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd {
namespace {

test::ProgramResult run_briefly(const std::string& recording, const test::TemporaryDirectory& directory) {
    return test::run_sherd({"run", std::string(SHERD_SCENES) + "/bowl_drop.toml", "-o", recording, "--set",
                            "duration=0.0005", "--set", "output.every=0.0001"},
                           directory.path);
}

std::string bytes(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// Hours of a run must not be lost, nor wrong steps recorded, because a later step has no solution.
TEST(Run, ThatCannotGoOnEndsWithARecordingOfWhatWas) {
    const test::TemporaryDirectory directory;
    const auto result =
        test::run_sherd({"run", std::string(SHERD_SCENES) + "/plate_drop.toml", "-o", "run.h5", "--set",
                         "solver.max_iterations=2", "--set", "solver.tolerance=1e-30"},
                        directory.path);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("cannot be solved"), std::string::npos) << result.err;
    const Recording recording(directory.path / "run.h5");
    EXPECT_EQ(recording.frame_count(), 1u);
    EXPECT_TRUE(recording.steps().empty());
    const auto info = test::run_sherd({"info", "run.h5"}, directory.path);
    EXPECT_NE(info.out.find("failed: step 1"), std::string::npos) << info.out;
}

// A face that is a needle requires too many explicit substeps. A user who chose explicit steps for collisions
// must be told that implicit steps were made instead.
TEST(Run, TellsWhereExplicitStepsCouldNotGoOn) {
    const test::TemporaryDirectory directory;
    std::ofstream(directory.path / "needle.obj") << "v 0 0 0\nv 1 0 0\nv 0.5 1e-9 0\nf 1 2 3\n";
    std::ofstream(directory.path / "scene.toml") << R"(
duration = 0.002
[sheet.plate]
mesh = { file = "needle.obj" }
material = { density = 7850, thickness = 0.0001, young = 2e11 }
place = { translate = [0, 0, 0.004] }
velocity = [0, 0, -3]
[obstacle.floor]
plane = {}
[solver]
scheme = "auto"
)";
    const auto result = test::run_sherd({"run", "scene.toml", "-o", "run.h5"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("they failed, and implicit steps continued"), std::string::npos) << result.out;
    const std::vector<StepReport> steps = Recording(directory.path / "run.h5").steps();
    EXPECT_TRUE(std::ranges::any_of(steps, [](const StepReport& step) {
        return step.urgency == Urgency::explicit_failed && !step.is_explicit;
    }));
}

// A single sliver in a scanned mesh makes a run thousands of times as long: the program must name the face.
TEST(Run, NamesTheFaceThatAsksForManySubsteps) {
    const test::TemporaryDirectory directory;
    std::ofstream(directory.path / "sliver.obj")
        << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 1e-4 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    std::ofstream(directory.path / "scene.toml") << R"(
duration = 2e-2
[sheet.plate]
mesh = { file = "sliver.obj" }
material = { density = 7850, thickness = 0.001, young = 2e11 }
[solver]
scheme = "explicit"
step = 1e-2
)";
    const auto result = test::run_sherd({"run", "scene.toml", "-o", "run.h5"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::string words = " at (0.5, 3.333e-05, 0) m at rest requires the shortest";
    const std::size_t found = result.err.find("the face of sheet.plate" + words);
    EXPECT_NE(found, std::string::npos) << result.err;
    EXPECT_EQ(result.err.find(words, found + 50), std::string::npos) << "once is enough\n" << result.err;
}

// A run whose time scheme diverges ends as complete, while one term of its balance takes all of the energy:
// without a message nobody would notice.
TEST(Run, TellsOfEnergyThatTheTimeSchemeMade) {
    const test::TemporaryDirectory directory;
    std::ofstream(directory.path / "scene.toml") << R"(
duration = 2e-3
[sheet.plate]
mesh = { generate = "rectangle", width = 0.06, height = 0.06, edge_length = 0.015 }
material = { preset = "steel", thickness = 0.001 }
velocity = [0, 0, -20]
place = { rotate = { axis = [1, 1, 0], degrees = 3 }, translate = [0, 0, 0.007] }
[obstacle.floor]
plane = { point = [0, 0, 0], normal = [0, 0, 1] }
[solver]
step = 3.5e-4
)";
    // From its history BDF2 predicts an impact badly when steps are long; implicit Euler only dissipates
    // energy.
    for (const std::string scheme : {"bdf2", "implicit-euler"}) {
        const auto result = test::run_sherd(
            {"run", "scene.toml", "-o", "run.h5", "--force", "--set", "solver.scheme=" + scheme},
            directory.path);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.out.find("energy gained") != std::string::npos, scheme == "bdf2") << result.out;
    }
}

// Users need to see what a run spends its time on, but must not have to filter it out of the results.
TEST(Run, TellsBesideItsResultsWhatTimeWasSpentOn) {
    const test::TemporaryDirectory directory;
    const auto result = run_briefly("run.h5", directory);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out.find("time spent on"), std::string::npos) << result.out;
    const std::size_t table = result.err.find("time spent on");
    ASSERT_NE(table, std::string::npos) << result.err;
    std::istringstream lines(result.err.substr(table));
    std::string line;
    std::getline(lines, line);
    double sum = 0, linear_solver = 0, solver_parts = 0, contact = 0;
    while (std::getline(lines, line)) {
        const double share = std::stod(line.substr(32));
        EXPECT_GE(share, 0) << line;
        (line.starts_with("  ") ? solver_parts : sum) += share;
        if (line.starts_with("contact")) contact = share;
        if (line.starts_with("linear solver")) linear_solver = share;
    }
    EXPECT_NEAR(sum, 100, 0.5) << result.err;
    EXPECT_GT(contact, 0);
    EXPECT_GT(linear_solver, 0);
    EXPECT_NEAR(solver_parts, linear_solver, 0.3);
}

// If the bytes differed, measured times would be in the recording, or would have influenced the run.
TEST(Run, TwoRunsRecordTheSameBytesButForTheirWallTime) {
    const test::TemporaryDirectory directory;
    for (const char* name : {"one.h5", "two.h5"}) {
        ASSERT_EQ(run_briefly(name, directory).exit_code, 0);
        hdf5::write_attribute(test::open_to_edit(directory.path / name), "wall_seconds", 1.0);
    }
    const std::string one = bytes(directory.path / "one.h5"), two = bytes(directory.path / "two.h5");
    ASSERT_EQ(one.size(), two.size());
    ASSERT_FALSE(one.empty());
    EXPECT_EQ(std::ranges::mismatch(one, two).in1 - one.begin(), std::ssize(one)) << "bytes are the same";
}

}  // namespace
}  // namespace sherd
