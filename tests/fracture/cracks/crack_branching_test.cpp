// SPDX-License-Identifier: GPL-3.0-or-later
// Tips that branch. If the vibration of an opening edge counted in the mean release, tips would branch
// everywhere; if near branches did not propagate together, one branch of each pair would stop at once, by
// the chance of the mesh.
#include "fracture/cracks/crack_branching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double plate_edge = 0.0016, limit = 1500;  // m, length of edges; m/s, speed limit of tips

/// Glass plate, 100 by 40 mm, that is open from the left to the middle.
BreakableShell half_open_plate() {
    Polygon outline;
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.1, 0.0}, {0.1, 0.04}, {0.0, 0.04}})
        outline.outline.emplace_back(x, y);
    outline.slits = {{{0, 0.02}, {0.05, 0.02}}};
    SheetInput input;
    input.mesh = generate_polygon(outline, {plate_edge, Layout::delaunay, 1});
    input.material = test::glass;
    input.strength = uniform_strength(1e12, Measure::stress);
    input.toughness.value = 7.5e5;
    input.toughness.speed_limit = limit;
    return BreakableShell({input});
}

/// Tip that propagates along x at its speed limit.
GrowingTip running_tip(const BreakableShell& plate, const Vector3d& place) {
    GrowingTip tip;
    (plate.mechanics().rest.colwise() - place).colwise().squaredNorm().minCoeff(&tip.vertex);
    tip.stride = plate_edge;
    tip.before = limit;
    return tip;
}

const Vector3d middle(0.05, 0.02, 0);

// The mean release must reach half of a new value in the time that the tip takes for two edges: a vibration
// within one edge must not make a tip branch.
TEST(CrackBranching, TheMeanReleaseFollowsWithinThreeEdges) {
    const BreakableShell plate = half_open_plate();
    GrowingTip tip = running_tip(plate, middle);
    const double step = 0.01 * plate_edge / limit;
    for (int i = 0; i < 200; ++i) update_mean_release(plate, tip, {}, 2, step);
    EXPECT_NEAR(tip.release, 4 * (1 - std::exp(-2.0 / 3)), 0.25);
    update_mean_release(plate, tip, {}, 3, 1);
    EXPECT_DOUBLE_EQ(tip.release, 9) << "in long steps it is that of the step";
}

// Residual stress does not vibrate: its share of the release must count in full beside the mean of the other
// loads, and must be reached within half a thickness of propagation, on any mesh.
TEST(CrackBranching, ResidualStressFeedsByTheThickness) {
    const BreakableShell plate = half_open_plate();
    TipLoad load;
    load.residual = 1;
    GrowingTip tip = running_tip(plate, middle);
    update_mean_release(plate, tip, load, 2, 1);
    EXPECT_DOUBLE_EQ(tip.release, 0.7 * 4);
    load.by_energy = true;
    update_mean_release(plate, tip, load, 2, 1);
    EXPECT_DOUBLE_EQ(tip.release, 4);
    tip.release = 0;
    const double step = 0.01 * test::glass.thickness / limit;
    for (int i = 0; i < 50; ++i) update_mean_release(plate, tip, load, 2, step);
    EXPECT_NEAR(tip.release, 4 * (1 - std::exp(-1.0)), 0.03);
    std::vector<GrowingTip> exempt_pairs{tip, running_tip(plate, middle + Vector3d(0, 4 * plate_edge, 0))};
    exempt_pairs[0].release = 5;
    exempt_pairs[0].other_branch = exempt_pairs[1].number = 1;
    EXPECT_TRUE(branches(plate, exempt_pairs[0], load, exempt_pairs, plate_edge / limit))
        << "it is a thickness and more away";
    load.residual = 0;
    EXPECT_FALSE(branches(plate, exempt_pairs[0], load, exempt_pairs, plate_edge / limit))
        << "it is four edges away";
}

TEST(CrackBranching, NeedsTwiceTheEnergyAndTheLimit) {
    const BreakableShell plate = half_open_plate();
    GrowingTip tip = running_tip(plate, middle);
    const double soon = plate_edge / limit;
    for (const bool by_energy : {false, true}) {
        TipLoad load;
        load.by_energy = by_energy;
        tip.release = by_energy ? 1.9 : 1.3;
        EXPECT_FALSE(branches(plate, tip, load, {}, soon));
        tip.release = by_energy ? 2.1 : 1.5;
        EXPECT_TRUE(branches(plate, tip, load, {}, soon));
        EXPECT_FALSE(branches(plate, tip, load, {}, 2 * soon)) << "it has come at half the limit";
    }
    tip.stride = 0;
    EXPECT_FALSE(branches(plate, tip, {}, {}, soon)) << "it has not run yet";
}

TEST(CrackBranching, GoesToBothSidesAlike) {
    const BreakableShell plate = half_open_plate();
    const GrowingTip tip = running_tip(plate, middle);
    const auto [one, other] = branch_directions(plate, tip, Vector3d::UnitX());
    EXPECT_NEAR(one.x(), std::cos(25 * std::numbers::pi / 180), 1e-12);
    EXPECT_NEAR(one.y(), std::sin(25 * std::numbers::pi / 180), 1e-12);
    EXPECT_NEAR(other.x(), one.x(), 1e-12);
    EXPECT_NEAR(other.y(), -one.y(), 1e-12);
    EXPECT_EQ(one.z(), 0);
}

// Branches propagate together as long as the mesh cannot distinguish them, and must not branch again at once.
TEST(CrackBranching, BranchesKeepTogetherAndApart) {
    const BreakableShell plate = half_open_plate();
    struct Gap {
        double edges;
        bool is_near, may_branch;
    };
    for (const auto& [edges, is_near, may_branch] :
         {Gap{2, true, false}, {5, false, false}, {11, false, true}}) {
        std::vector<GrowingTip> all;
        for (const double side : {0.5, -0.5})
            all.push_back(running_tip(plate, Vector3d(0.075, 0.02 + side * edges * plate_edge, 0)));
        all[1].number = 1;
        all[0].other_branch = 1;
        all[1].other_branch = 0;
        all[0].release = 5;
        EXPECT_EQ(near_branch(plate, all[0], all) == &all[1], is_near) << edges << " edges apart";
        EXPECT_EQ(branches(plate, all[0], {}, all, plate_edge / limit), may_branch) << edges;
        all[0].other_branch = 7;
        EXPECT_EQ(near_branch(plate, all[0], all), nullptr) << "that one is no more";
    }
}

}  // namespace
}  // namespace sherd
