// SPDX-License-Identifier: GPL-3.0-or-later
// Compares plates and shells, computed from scenes, with theory and published numbers. The bounds are the
// measured errors plus a margin. Errors of loads, supports, gauges and paths would show here as well as
// errors of hinges.
#include <gtest/gtest.h>

#include "app/bench/shell/shell_run.h"

namespace sherd::test {
namespace {

struct Bound {
    const char* name;
    double edge;
    double error;  ///< %, bound of the error of every number
    const char* membrane = "";
};

class ShellBench : public testing::TestWithParam<Bound> {};

TEST_P(ShellBench, OfCoupledHingesIsNearPublishedNumbers) {
    const auto& [name, edge, error, membrane] = GetParam();
    for (const ShellCase& one : shell_cases()) {
        if (one.name != name) continue;
        const ShellRun run = run_case(one, {.edge = edge, .membrane = membrane});
        EXPECT_EQ(run.failure, "");
        const std::size_t known = one.references.size() + 4 * one.limits.size() + one.frequencies.size();
        if (one.measure)
            ASSERT_GT(run.results.size(), known);
        else
            ASSERT_EQ(run.results.size(), known);
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

INSTANTIATE_TEST_SUITE_P(Plates, ShellBench,
                         testing::Values(Bound{"plate, free square, frequencies", 0.05, 2},
                                         Bound{"plate, supported square under pressure", 0.05, 0.6},
                                         Bound{"plate, clamped square under pressure", 0.025, 0.8},
                                         Bound{"plate, orthotropic strips", 0.05, 2},
                                         Bound{"strip, heavy elastica", 0.1, 0.8},
                                         Bound{"plate, twisted strip", 0.1, 0.05},
                                         Bound{"plate, clamped ring under pressure", 0.03, 2.3},
                                         Bound{"plate, moments of the clamped ring", 0.03, 9},
                                         Bound{"plate with a hole, bent", 0.08, 4},
                                         Bound{"hyperboloid, free ends, t = 0.1", 0.1, 0.6},
                                         Bound{"hyperboloid, free ends, t = 0.01", 0.1, 0.6},
                                         Bound{"hyperboloid, free ends, t = 0.001", 0.1, 1, "arc"}));

// Errors of plain hinges, the reason for coupled hinges in docs/theory/bending.md: if they become smaller,
// that page must be corrected.
struct Range {
    const char* name;
    double edge;
    double least, most;  ///< %, range of the largest error
};

class PlainShellBench : public testing::TestWithParam<Range> {};

TEST_P(PlainShellBench, IsAsFarFromThemAsIsSaid) {
    const auto& [name, edge, least, most] = GetParam();
    for (const ShellCase& one : shell_cases()) {
        if (one.name != name) continue;
        const ShellRun run = run_case(one, {.edge = edge, .bending = "cubic"});
        EXPECT_EQ(run.failure, "");
        EXPECT_GT(run.largest_error(), least);
        EXPECT_LT(run.largest_error(), most);
        return;
    }
    FAIL() << "no such case";
}

INSTANTIATE_TEST_SUITE_P(Plates, PlainShellBench,
                         testing::Values(Range{"plate, free square, frequencies", 0.05, 30, 45},
                                         Range{"plate, supported square under pressure", 0.05, 9, 15},
                                         Range{"plate, moments of the clamped ring", 0.03, 22, 27},
                                         Range{"strip, heavy elastica", 0.05, 2, 12}));

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
