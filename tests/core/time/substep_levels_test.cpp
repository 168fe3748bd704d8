// SPDX-License-Identifier: GPL-3.0-or-later
// Choice of substeps and levels. A level that is too low for a vertex would let it explode; a choice that
// costs more than plain substeps would be pointless.
#include "core/time/substep_levels.h"

#include <gtest/gtest.h>

#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

/// Stable steps of a plate in which a few vertices are `ratio` times faster than the others.
VectorXd with_few_fast(const Shell& shell, double ratio) {
    VectorXd stable = VectorXd::Constant(shell.mass.size(), 1e-6);
    for (const Index v : {200, 201, 450}) stable[v] /= ratio;
    return stable;
}

TEST(SubstepLevels, EveryVertexIsFollowedAsOftenAsItNeeds) {
    const Shell shell = test::stacked_plates(1, 30, 0, test::glass);
    for (const double ratio : {1.0, 1.5, 4.0, 16.0, 50.0}) {
        const VectorXd stable = with_few_fast(shell, ratio);
        const LevelLimits limits{true, 0.7};
        const SubstepLevels found = substep_levels(shell, stable, 1e-5, limits);
        int plain = 0;
        for (Index v = 0; v < static_cast<Index>(stable.size()); ++v) {
            const int parts = 1 << found.levels[v];
            const double length = 1e-5 / found.substeps / parts;
            EXPECT_LE(length, (parts > 1 ? limits.factor : 1) * stable[v] * (1 + 1e-9)) << "vertex " << v;
            plain += parts == 1;
        }
        if (ratio >= 4) {
            EXPECT_LE(found.substeps, 10) << "most vertices set the substep";
            EXPECT_GT(plain, 600);
        }
    }
}

// Where all vertices are equally fast, or levels are not allowed, all have level 0.
TEST(SubstepLevels, ArePlainWhereLevelsDoNotHelp) {
    const Shell shell = test::stacked_plates(1, 10, 0, test::glass);
    const auto expect_plain = [&](const VectorXd& stable, const LevelLimits& limits, int substeps) {
        const SubstepLevels found = substep_levels(shell, stable, 1e-5, limits);
        EXPECT_EQ(found.substeps, substeps);
        EXPECT_EQ(*std::ranges::max_element(found.levels), 0);
    };
    expect_plain(VectorXd::Constant(shell.mass.size(), 1e-6), {}, 10);
    VectorXd one_fast = VectorXd::Constant(shell.mass.size(), 1e-6);
    one_fast[60] = 1e-7;
    expect_plain(one_fast, {false}, 100);
    expect_plain(one_fast, {true, 1, 1e-6 * 2}, 100);
}

// Levels disturb: a small gain is no reason to change the number of substeps.
TEST(SubstepLevels, KeepTheLastNumberOfSubsteps) {
    const Shell shell = test::stacked_plates(1, 30, 0, test::glass);
    const VectorXd stable = with_few_fast(shell, 16);
    const int best = substep_levels(shell, stable, 1e-5, {true, 0.7}).substeps;
    EXPECT_EQ(substep_levels(shell, stable, 1e-5, {true, 0.7, 0, best + 1}).substeps, best + 1);
    EXPECT_EQ(substep_levels(shell, stable, 1e-5, {true, 0.7, 0, 100}).substeps, best);
}

}  // namespace
}  // namespace sherd
