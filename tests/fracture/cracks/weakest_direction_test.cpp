// SPDX-License-Identifier: GPL-3.0-or-later
// If cracks propagated in the direction of the largest tension in a sheet like wood, they would run across
// the grain.
#include "fracture/cracks/weakest_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fracture/cracks/tip_stress.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double degree = std::numbers::pi / 180, along = 1e6, across = 4e6;

/// Square whose first material axis is turned by `axis` (rad) from x. pulled_along, pulled_across: K_Ic of
/// pulls along this axis and across it.
BreakableShell square(double axis, double pulled_along, double pulled_across) {
    SheetInput input;
    input.mesh = generate_rectangle(1, 1, {0.1, Layout::delaunay, 1});
    input.material = test::glass;
    input.strength = uniform_strength(1e9, Measure::stress);
    input.toughness.value = pulled_along;
    input.toughness.across = pulled_across;
    input.toughness.speed_limit = 1500;
    input.axes.assign(input.mesh.number_of_faces(), Vector3d(std::cos(axis), std::sin(axis), 0));
    return BreakableShell({input});
}

GrowingTip middle_tip(const BreakableShell& sheet) {
    GrowingTip tip;
    (sheet.mechanics().rest.colwise() - Vector3d(0.5, 0.5, 0)).colwise().squaredNorm().minCoeff(&tip.vertex);
    return tip;
}

/// Kink angle, rad, of the largest G / G_c, by a search with the toughness of the material.
double expected_kink(const Toughness& toughness, double axis) {
    double best = 0, largest = 0;
    for (double kink = -75 * degree; kink <= 75 * degree; kink += 0.05 * degree) {
        const double needed = directional_toughness(toughness, kink - axis);
        const double ratio = std::pow(std::cos(kink / 2), 4) / (needed * needed);
        if (ratio > largest) best = kink;
        largest = std::max(largest, ratio);
    }
    return best;
}

TEST(WeakestDirection, IsThatOfTheLargestReleaseOverWhatIsNeeded) {
    for (const double axis : {20.0, 45.0, -60.0, 80.0}) {
        const BreakableShell sheet = square(axis * degree, along, across);
        const GrowingTip tip = middle_tip(sheet);
        TipLoad load;
        load.intensity = 2e6;
        turn_to_weakest(sheet, tip, load);
        const double kink = std::atan2(load.direction.y(), load.direction.x());
        EXPECT_NEAR(kink / degree, expected_kink(sheet.toughness_of_sheet(0), axis * degree) / degree, 1)
            << axis;
        EXPECT_NEAR(load.intensity, 2e6 * std::pow(std::cos(kink / 2), 2), 1e-6 * 2e6) << axis;
    }
}

TEST(WeakestDirection, LeavesASheetWithoutDirectionsAlone) {
    const BreakableShell sheet = square(0.3, along, along);
    TipLoad load;
    load.intensity = 2e6;
    turn_to_weakest(sheet, middle_tip(sheet), load);
    EXPECT_EQ(load.direction, Vector3d::UnitX());
    EXPECT_EQ(load.intensity, 2e6);
}

// A tip that is driven by stress must not turn by more than its largest turn: otherwise the grain would
// break the path into saw teeth.
TEST(WeakestDirection, ATipThatRunsTurnsSlowly) {
    const BreakableShell sheet = square(45 * degree, along, across);
    GrowingTip tip = middle_tip(sheet);
    tip.stride = 0.1;
    TipLoad load;
    turn_to_weakest(sheet, tip, load);
    EXPECT_LE(std::abs(std::atan2(load.direction.y(), load.direction.x())),
              largest_tip_turn(sheet, tip) + 1e-12);
    load = {};
    load.by_energy = true;
    turn_to_weakest(sheet, tip, load);
    EXPECT_GT(std::abs(std::atan2(load.direction.y(), load.direction.x())), 10 * degree)
        << "by energy it may";
}

}  // namespace
}  // namespace sherd
