// SPDX-License-Identifier: GPL-3.0-or-later
// Published shells, computed by statics from scenes: the bounds are what was measured plus a little. Loads,
// supports, gauges and paths are held by it as much as hinges are.
#include <gtest/gtest.h>

#include "app/bench/shell_run.h"

namespace sherd::test {
namespace {

struct Bound {
    const char* name;
    double edge;
    double error;  ///< %, of every number
    const char* membrane = "";
};

class ShellBench : public testing::TestWithParam<Bound> {};

TEST_P(ShellBench, OfCoupledHingesIsNearPublishedNumbers) {
    const auto& [name, edge, error, membrane] = GetParam();
    for (const ShellCase& one : sze_cases()) {
        if (one.name != name) continue;
        const ShellRun run = run_case(one, {.edge = edge, .membrane = membrane});
        EXPECT_EQ(run.failure, "");
        ASSERT_EQ(run.results.size(), one.references.size() + 4 * one.limits.size());
        for (const ShellResult& result : run.results)
            EXPECT_NEAR(result.error(), 0, error) << result.name << ": " << result.value;
        return;
    }
    FAIL() << "no such case";
}

INSTANTIATE_TEST_SUITE_P(
    Cases, ShellBench,
    testing::Values(Bound{"cantilever, end shear", 0.5, 0.5}, Bound{"cantilever, end moment", 0.5, 0.5},
                    Bound{"slit annular plate", 1, 4}, Bound{"hemisphere with a hole", 0.8, 3},
                    Bound{"hemisphere with a hole", 0.8, 3, "arc"}, Bound{"slit annular plate", 1, 4, "arc"},
                    Bound{"cylinder, pulled", 0.3, 1.5}, Bound{"semi-cylinder, pinched", 10, 3},
                    Bound{"hinged roof, h = 12.7", 32, 4}, Bound{"hinged roof, h = 6.35", 32, 7}));

// Why there are coupled hinges at all.
TEST(ShellBenchOfPlainHinges, IsFarFromIt) {
    for (const ShellCase& one : sze_cases()) {
        if (one.name != "hemisphere with a hole") continue;
        for (const ShellResult& result :
             run_case(one, {.edge = 0.8, .structured = true, .bending = "cubic"}).results)
            EXPECT_LT(result.error(), -15) << result.name;
    }
}

}  // namespace
}  // namespace sherd::test
