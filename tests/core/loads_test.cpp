// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/loads.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/time/implicit_stepper.h"
#include "tests/support/small_sheet.h"
#include "tests/support/steps.h"

namespace sherd {
namespace {

const Material material{1000, 0.01, 1e6, 0.3};

std::vector<Index> all_triangles(const Sheet& sheet) {
    std::vector<Index> triangles(sheet.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0);
    return triangles;
}

Load pressure_on_all(const Sheet& sheet, double pressure) {
    Load load;
    load.pressed = all_triangles(sheet);
    load.pressure = pressure;
    return load;
}

Positions crumpled(const Sheet& sheet, unsigned seed) {
    test::Random random(seed);
    Positions x = sheet.rest;
    for (double& entry : x.reshaped()) entry += random.uniform(-0.2, 0.2);
    return x;
}

/// The energy of loads in a step that ends at `end` (s).
LoadEnergy loaded(const Sheet& sheet, const std::vector<Load>& loads, double end) {
    return test::begun(LoadEnergy(sheet, loads), sheet, end - 1, 1);
}

Positions forces(const Energy& energy, const Positions& x) {
    Positions gradient = Positions::Zero(3, x.cols());
    energy.add_gradient(x, gradient);
    return -gradient;
}

// Newton's method would not converge, or to something else.
TEST(Loads, GradientAndHessianAreDerivatives) {
    for (const Sheet& sheet : {test::tetrahedron(material), test::two_triangles(material)}) {
        Load load = pressure_on_all(sheet, 30);
        load.dead = area_forces(sheet, load.pressed, {1, 2, 3});
        test::expect_derivatives(loaded(sheet, {load}, 1), crumpled(sheet, 1), 1e-4, 1e-7);
    }
}

// A balloon would fly away by itself.
TEST(Loads, PressureInAClosedSheetHasNoNetForceAndFollowsItsNormals) {
    const Sheet sheet = test::tetrahedron(material);
    const LoadEnergy energy = loaded(sheet, {pressure_on_all(sheet, 30)}, 0);
    const Positions x = crumpled(sheet, 2);
    const Positions force = forces(energy, x);
    Positions expected = Positions::Zero(3, 4);
    for (const TriangleStencil& triangle : sheet.triangles) {
        const TrianglePositions t = columns(x, triangle.vertices);
        const Vector3d area = 0.5 * Vector3d(t.col(1) - t.col(0)).cross(Vector3d(t.col(2) - t.col(0)));
        for (const Index v : triangle.vertices) expected.col(v) += 30.0 / 3 * area;
    }
    EXPECT_LT((force - expected).norm(), 1e-13 * expected.norm());
    EXPECT_LT(force.rowwise().sum().norm(), 1e-13 * force.norm());
}

// At the free rim the force is the exact one of the beginning of the step.
TEST(Loads, PressureOnAnOpenSheetIsExactAtTheBeginningOfTheStep) {
    Sheet sheet = test::two_triangles(material);
    sheet.position = crumpled(sheet, 3);
    const Positions force = forces(loaded(sheet, {pressure_on_all(sheet, 5)}, 0), sheet.position);
    Vector3d area = Vector3d::Zero();
    for (const TriangleStencil& triangle : sheet.triangles) {
        const TrianglePositions t = columns(sheet.position, triangle.vertices);
        area += 0.5 * Vector3d(t.col(1) - t.col(0)).cross(Vector3d(t.col(2) - t.col(0)));
    }
    EXPECT_LT((force.rowwise().sum() - 5 * area).norm(), 1e-12 * force.norm());
}

// Load a length, an area and a vertex: the totals are what the units say.
TEST(Loads, DeadLoadsAddUpToForceTimesExtent) {
    const Sheet sheet = test::two_triangles(material);
    const auto total = [&](const std::vector<CornerForce>& dead) {
        Load load;
        load.dead = dead;
        return Vector3d(forces(loaded(sheet, {load}, 0), sheet.rest).rowwise().sum());
    };
    const Vector3d f(1, -2, 3);
    const double area = sheet.triangles[0].membrane.area + sheet.triangles[1].membrane.area;
    EXPECT_LT((total(area_forces(sheet, all_triangles(sheet), f)) - area * f).norm(), 1e-13);
    EXPECT_LT((total(point_forces(sheet, std::array<Index, 2>{1, 3}, f)) - 2 * f).norm(), 1e-13);
    const std::vector<char> ends{1, 0, 1, 0};
    const std::vector<TriangleSide> sides = boundary_sides(sheet, ends);
    ASSERT_EQ(sides.size(), 1u);
    const double length = (sheet.rest.col(0) - sheet.rest.col(2)).norm();
    EXPECT_LT((total(line_forces(sheet, sides, f)) - length * f).norm(), 1e-13);
    // The diagonal is not a boundary: 0, 1 alone select no side.
    EXPECT_TRUE(boundary_sides(sheet, std::vector<char>{1, 1, 0, 0}).empty());
}

// The momentum that a free sheet gains is the ramp's impulse, by the rule that implicit Euler integrates
// with.
TEST(Loads, RampGrowsLinearlyAndThenStays) {
    Sheet sheet = test::two_triangles(material);
    StepperOptions options;
    options.gravity.setZero();
    options.step = 0.01;
    Load load;
    load.dead = area_forces(sheet, all_triangles(sheet), {0, 0, 2});
    load.ramp = 0.04;
    options.shell.loads = {load};
    const double force = 2 * (sheet.triangles[0].membrane.area + sheet.triangles[1].membrane.area);
    ImplicitStepper step(sheet, options);
    double impulse = 0;
    for (int i = 1; i <= 6; ++i) {
        step.begin();
        ASSERT_TRUE(step.solve(50).converged);
        step.finish();
        impulse += force * std::min(1.0, i / 4.0) * options.step;
        EXPECT_NEAR(linear_momentum(sheet).z(), impulse, 1e-9 * impulse);
    }
}

}  // namespace
}  // namespace sherd
