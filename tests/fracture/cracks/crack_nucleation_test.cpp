// SPDX-License-Identifier: GPL-3.0-or-later
// Nucleation of cracks, and the time that is left until then: explicit steps are longer meanwhile, so that a
// crack would nucleate too late if this time were too long.
#include "fracture/cracks/crack_nucleation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/shell/face_fields.h"
#include "fracture/shell/toughness.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double tension_strength = 4e7;  // Pa

BreakableShell glass_square() {
    SheetInput input;
    input.mesh = generate_rectangle(0.06, 0.06, {0.006, Layout::delaunay, 1});
    input.material = test::glass;
    input.strength = uniform_strength(tension_strength, Measure::stress);
    input.toughness = {.value = 1e6, .speed_limit = usual_speed_limit(test::glass)};
    return BreakableShell({input});
}

/// The square stretched along x such that its stress is `ratio` times the strength.
struct Stretched {
    FaceStrains strains;
    HingeMeasures measures;

    Stretched(const BreakableShell& square, double ratio) {
        const Shell& shell = square.mechanics();
        const double strain =
            ratio * tension_strength * (1 - std::pow(test::glass.poisson, 2)) / test::glass.young;
        Positions x = shell.rest;
        x.row(0) *= std::sqrt(1 + 2 * strain);  // Green's strain
        strains.membrane = green_strains(shell, x);
        strains.curvature = Eigen::Matrix3Xd::Zero(3, strains.membrane.cols());
        measures = hinge_measures(square, x, strains.curvature, strains.membrane, {});
    }
};

TEST(CrackNucleation, TellsTheTimeThatIsLeft) {
    const BreakableShell square = glass_square();
    for (const double ratio : {0.6, 0.8, 1.2, 2.0}) {
        CrackNucleation nucleation(square, false);
        const Stretched now(square, ratio), grown(square, 1.5 * ratio);
        EXPECT_FALSE(nucleation.next(now.strains, now.measures, {}, 0));
        const double left = nucleation.time_left();
        if (ratio < 1 / 1.5) {
            EXPECT_EQ(left, std::numeric_limits<double>::infinity());
            continue;
        }
        double time = 0;
        while (time < 10 * left && !nucleation.next(grown.strains, grown.measures, {}, left / 100))
            time += left / 100;
        EXPECT_NEAR(time, left, 0.03 * left) << ratio;
    }
}

TEST(CrackNucleation, LeavesLessTimeTheLongerAHingeIsOverloaded) {
    const BreakableShell square = glass_square();
    const Stretched now(square, 2);
    CrackNucleation nucleation(square, false);
    nucleation.next(now.strains, now.measures, {}, 0);
    const double all = nucleation.time_left();
    nucleation.next(now.strains, now.measures, {}, all);
    EXPECT_NEAR(nucleation.time_left(), 0.75 * all, 0.01 * all)
        << "it is exposed to (2 - 1)^2, not (3 - 1)^2";
}

TEST(CrackNucleation, NeedsNoTimeInStatics) {
    const BreakableShell square = glass_square();
    const Stretched under(square, 0.99), over(square, 1.02);
    CrackNucleation nucleation(square, true);
    EXPECT_FALSE(nucleation.next(under.strains, under.measures, {}, 0));
    EXPECT_TRUE(nucleation.next(over.strains, over.measures, {}, 0));
}

}  // namespace
}  // namespace sherd
