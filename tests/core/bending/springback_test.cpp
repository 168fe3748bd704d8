// SPDX-License-Identifier: GPL-3.0-or-later
// A strip that is bent far beyond yield and released must keep the curvature that a strip of metal keeps,
// and the energy balance must include the energy that yielding takes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/time/stepper.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/yielding_layers.h"

namespace sherd {
namespace {

constexpr double length = 0.2, width = 0.02;  // m
using namespace test::yielding;
const Material spring_steel{
    .density = 7850, .thickness = thickness, .young = young, .poisson = poisson, .yield = yield};

/// Strip along x of 30 by 3 squares, bent to `curvature` (1/m).
Shell bent_strip(double curvature) {
    constexpr int columns = 30, rows = 3;
    Positions rest(3, (columns + 1) * (rows + 1));
    std::vector<std::array<Index, 3>> triangles;
    for (int i = 0; i <= columns; ++i)
        for (int j = 0; j <= rows; ++j) {
            const Index v = i * (rows + 1) + j, next = v + rows + 1;
            rest.col(v) << length * i / columns - length / 2, width * j / rows, 0;
            if (i == columns || j == rows) continue;
            triangles.push_back({v, next, next + 1});
            triangles.push_back({v, next + 1, v + 1});
        }
    Shell shell = test::small_sheet(rest, triangles, spring_steel);
    shell.face_sheet.assign(shell.triangles.size(), 0);
    for (Index v = 0; v < rest.cols(); ++v)
        shell.position.col(v) << std::sin(curvature * rest(0, v)) / curvature, rest(1, v),
            (1 - std::cos(curvature * rest(0, v))) / curvature;
    return shell;
}

/// Curvature, 1/m, of the circle through the middle and the quarter points of the strip's middle line.
double curvature(const Shell& shell) {
    const auto at = [&](int column) {
        return Vector3d((shell.position.col(4 * column + 1) + shell.position.col(4 * column + 2)) / 2);
    };
    const Vector3d a = at(7) - at(15), b = at(23) - at(15);
    return 2 * a.cross(b).norm() / (a.norm() * b.norm() * (a - b).norm());
}

/// Releases the strip and makes `count` steps of `step` s. Returns the stepper.
std::unique_ptr<Stepper> released(Shell& shell, double step, int count) {
    StepperOptions options;
    options.step = step;
    options.gravity.setZero();
    options.tolerance = 1e-10;
    options.shell.yields = {yield};
    std::unique_ptr<Stepper> stepper = make_stepper(shell, options);
    for (int i = 0; i < count; ++i) {
        EXPECT_TRUE(stepper->begin());
        EXPECT_TRUE(stepper->solve(1000));  // such long steps need very different numbers of iterations
        stepper->finish();
    }
    return stepper;
}

// Layers through the thickness are the reference. Steps are far longer than a period of vibration, so that
// no wave of curvature bends the strip further.
TEST(Springback, AStripOfSteelKeepsWhatLayersDo) {
    for (const double ratio : {2.0, 4.0}) {
        Shell shell = bent_strip(ratio * first);
        released(shell, 0.1, 20);
        Layers layers;  // bent to the same curvature, then released in both directions
        const Vector3d bent(ratio * first, 0, 0);
        EXPECT_NEAR(curvature(shell), Layers::plastic_curvature(bent, layers.bend(bent))[0], 0.03 * first)
            << ratio;
    }
}

TEST(Springback, WithinYieldAStripSpringsBackWholly) {
    Shell shell = bent_strip(0.8 * first);
    EXPECT_EQ(released(shell, 0.1, 20)->balance().lost_to_yield, 0);
    EXPECT_LT(curvature(shell), 1e-3 * first);
}

// When the strip is released, a wave of curvature runs in from its ends and bends it further.
TEST(Springback, WhatYieldingTakesIsInTheBalance) {
    Shell shell = bent_strip(4 * first);
    const auto stepper = released(shell, 1e-4, 50);
    const EnergyBalance& balance = stepper->balance();
    EXPECT_GT(balance.lost_to_yield, 0);
    EXPECT_NEAR(balance.unexplained, 0, 1e-8 * balance.lost_to_yield);
}

}  // namespace
}  // namespace sherd
