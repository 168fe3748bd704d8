// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of `sherd check` and of a run's table about the step that resolves cracks. Without them a user
// would not notice that a crack has crossed the sheet within one implicit step.
#include <gtest/gtest.h>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

/// Notched strip, pulled apart. A crack at 750 m/s, its speed limit, passes an edge of 8 mm in 1.07e-5 s.
const std::string notched_strip = R"(duration = 4e-4
[sheet.strip]
mesh = { generate = "rectangle", width = 0.1, height = 0.06, edge_length = 0.008 }
material = { preset = "glass" }
pin = [
    { box = [[-1, -1, -1], [1e-4, 1, 1]] },
    { box = [[0.0999, -1, -1], [1, 1, 1]], keys = [{ time = 0 }, { time = 4e-4, translate = [1e-4, 0, 0] }] },
]
[sheet.strip.fracture]
strength = 1e9
toughness = 0.75e6
speed_limit = 750
crack = { line = [[0.05, 0, 0], [0.05, 0.02, 0]] }
[force]
gravity = [0, 0, 0]
[solver]
step = 4e-5
)";

/// Line of the program's output about the propagation of cracks; empty if there is none.
std::string words_of_cracks(std::vector<std::string> arguments, const std::vector<std::string>& sets,
                            const std::string& scene = notched_strip) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", scene);
    for (const std::string& set : sets) arguments.insert(arguments.end(), {"--set", set});
    const ProgramResult result = run_sherd(arguments, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::size_t at = result.out.find("\ncracks run");
    return at == std::string::npos ? "" : result.out.substr(at + 1, result.out.find('\n', at + 1) - at - 1);
}

std::string checked_strip(const std::vector<std::string>& sets, const std::string& scene = notched_strip) {
    return words_of_cracks({"check", "scene.toml", "--no-try"}, sets, scene);
}

std::string table_of_strip(const std::vector<std::string>& sets) {
    return words_of_cracks({"run", "scene.toml"}, sets);
}

TEST(CrackStep, CheckSaysHowFarACrackRunsInAStepAndWhichOneResolvesIt) {
    EXPECT_EQ(checked_strip({}),
              "cracks run up to 4 edges a step; solver.step = 1e-05 resolves them edge by edge");
    EXPECT_EQ(checked_strip({"solver.step=9e-6"}),
              "cracks run one edge a step, as steps of up to 1e-05 s resolve them");
    EXPECT_EQ(checked_strip({"sheet.strip.fracture={ strength = 1e9 }"}), "");
}

TEST(CrackStep, StaticsHaveNone) {
    const std::string timeless = notched_strip.substr(notched_strip.find('\n'));
    EXPECT_EQ(checked_strip({"solver.scheme=static", "solver.step=0.5"}, timeless), "");
}

// Explicit steps let a crack advance by one edge at most, so that long steps hold cracks back.
TEST(CrackStep, ExplicitStepsAreToldWhereTheyHoldCracksBack) {
    EXPECT_EQ(checked_strip({"solver.scheme=explicit", "solver.step=2e-6"}), "");
    EXPECT_EQ(
        checked_strip({"solver.scheme=explicit", "solver.step=2e-5"}),
        "cracks run one edge a step, slower than their speed limit; solver.step = 1e-05 lets them reach "
        "it");
}

TEST(CrackStep, TheTableOfARunSaysItWhereCracksGrew) {
    EXPECT_EQ(table_of_strip({}),
              "cracks run            up to 4 edges a step; solver.step = 1e-05 resolves them edge by edge");
    EXPECT_EQ(table_of_strip({"sheet.strip.fracture.toughness=1e9"}), "") << "nothing grew";
}

}  // namespace
}  // namespace sherd::test
