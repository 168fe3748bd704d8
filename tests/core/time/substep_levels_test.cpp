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
            const int short_steps = found.levels.empty() ? 1 : 1 << found.levels[v];
            const double length = 1e-5 / found.substeps / short_steps;
            EXPECT_LE(length, (short_steps > 1 ? limits.share : 1) * stable[v] * (1 + 1e-9))
                << "vertex " << v;
            plain += short_steps == 1;
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
        EXPECT_TRUE(found.levels.empty());
    };
    expect_plain(VectorXd::Constant(shell.mass.size(), 1e-6), {}, 10);
    VectorXd one_fast = VectorXd::Constant(shell.mass.size(), 1e-6);
    one_fast[60] = 1e-7;
    expect_plain(one_fast, {false}, 100);
    expect_plain(one_fast, {true, 1, 1e-6 * 2}, 100);
}

}  // namespace
}  // namespace sherd
