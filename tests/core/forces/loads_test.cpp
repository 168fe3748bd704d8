// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/loads.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/time/implicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

std::vector<Index> all_triangles(const Shell& shell) {
    std::vector<Index> triangles(shell.triangles.size());
    std::iota(triangles.begin(), triangles.end(), 0);
    return triangles;
}

Load pressure_on_all(const Shell& shell, double pressure) {
    Load load;
    load.pressed = all_triangles(shell);
    load.pressure = pressure;
    return load;
}

Positions crumpled(const Shell& shell, unsigned seed) {
    test::Random random(seed);
    Positions x = shell.rest;
    for (double& entry : x.reshaped()) entry += random.uniform(-0.2, 0.2);
    return x;
}

/// Energy of loads in a step of 1 s that ends at `end` (s).
LoadEnergy loaded(const Shell& shell, const std::vector<Load>& loads, double end) {
    return test::begun(LoadEnergy(shell, loads), shell, end - 1, 1);
}

Positions forces(const Energy& energy, const Positions& x) {
    Positions gradient = Positions::Zero(3, x.cols());
    energy.add_gradient(x, gradient);
    return -gradient;
}

// With wrong derivatives Newton's method would not converge, or would find a wrong shape.
TEST(Loads, GradientAndHessianAreDerivatives) {
    for (const Shell& shell : {test::tetrahedron(test::thick_foam), test::two_triangles(test::thick_foam)}) {
        Load load = pressure_on_all(shell, 30);
        load.spread = area_forces(shell, load.pressed, {1, 2, 3});
        test::expect_derivatives(loaded(shell, {load}, 1), crumpled(shell, 1), 1e-4, 1e-7);
    }
}

// With a net force a balloon would fly away by itself.
TEST(Loads, PressureInAClosedSheetHasNoNetForceAndFollowsItsNormals) {
    const Shell shell = test::tetrahedron(test::thick_foam);
    const LoadEnergy energy = loaded(shell, {pressure_on_all(shell, 30)}, 0);
    const Positions x = crumpled(shell, 2);
    const Positions force = forces(energy, x);
    Positions expected = Positions::Zero(3, 4);
    for (const TriangleStencil& triangle : shell.triangles) {
        const TrianglePositions t = columns(x, triangle.vertices);
        const Vector3d area = 0.5 * Vector3d(t.col(1) - t.col(0)).cross(Vector3d(t.col(2) - t.col(0)));
        for (const Index v : triangle.vertices) expected.col(v) += 30.0 / 3 * area;
    }
    EXPECT_LT((force - expected).norm(), 1e-13 * expected.norm());
    EXPECT_LT(force.rowwise().sum().norm(), 1e-13 * force.norm());
}

// At the free rim of an open sheet, the force of a pressure must be exact at the positions at the beginning
// of the step.
TEST(Loads, PressureOnAnOpenSheetIsExactAtTheBeginningOfTheStep) {
    Shell shell = test::two_triangles(test::thick_foam);
    shell.position = crumpled(shell, 3);
    const Positions force = forces(loaded(shell, {pressure_on_all(shell, 5)}, 0), shell.position);
    Vector3d area = Vector3d::Zero();
    for (const TriangleStencil& triangle : shell.triangles) {
        const TrianglePositions t = columns(shell.position, triangle.vertices);
        area += 0.5 * Vector3d(t.col(1) - t.col(0)).cross(Vector3d(t.col(2) - t.col(0)));
    }
    EXPECT_LT((force.rowwise().sum() - 5 * area).norm(), 1e-12 * force.norm());
}

// Loads per length, per area and on a vertex: the total must be the given force times the length, the area
// or the number of vertices.
TEST(Loads, DeadLoadsAddUpToForceTimesExtent) {
    const Shell shell = test::two_triangles(test::thick_foam);
    const auto total = [&](const std::vector<CornerForce>& dead, const std::vector<FaceForce>& spread = {}) {
        Load load;
        load.dead = dead;
        load.spread = spread;
        return Vector3d(forces(loaded(shell, {load}, 0), shell.rest).rowwise().sum());
    };
    const Vector3d f(1, -2, 3);
    const double area = shell.triangles[0].membrane.area + shell.triangles[1].membrane.area;
    EXPECT_LT((total({}, area_forces(shell, all_triangles(shell), f)) - area * f).norm(), 1e-13);
    EXPECT_LT((total(point_forces(shell, std::array<Index, 2>{1, 3}, f)) - 2 * f).norm(), 1e-13);
    const std::vector<char> ends{1, 0, 1, 0};
    const std::vector<TriangleEdge> sides = boundary_triangle_edges(shell, ends);
    ASSERT_EQ(sides.size(), 1u);
    const double length = (shell.rest.col(0) - shell.rest.col(2)).norm();
    EXPECT_LT((total(line_forces(shell, sides, f)) - length * f).norm(), 1e-13);
    // Vertices 0 and 1 select no side: the diagonal between them is no boundary.
    EXPECT_TRUE(boundary_triangle_edges(shell, std::vector<char>{1, 1, 0, 0}).empty());
}

// The momentum that a free sheet gains must be the impulse of the load by implicit Euler: the sum of the
// forces at the ends of the steps, times their length.
TEST(Loads, RampGrowsLinearlyAndThenStays) {
    Shell shell = test::two_triangles(test::thick_foam);
    StepperOptions options;
    options.gravity.setZero();
    options.step = 0.01;
    Load load;
    load.spread = area_forces(shell, all_triangles(shell), {0, 0, 2});
    load.ramp = 0.04;
    options.shell.loads = {load};
    const double force = 2 * (shell.triangles[0].membrane.area + shell.triangles[1].membrane.area);
    ImplicitStepper step(shell, options);
    double impulse = 0;
    for (int i = 1; i <= 6; ++i) {
        step.begin();
        ASSERT_TRUE(step.solve(50));
        step.finish();
        impulse += force * std::min(1.0, i / 4.0) * options.step;
        EXPECT_NEAR(linear_momentum(shell).z(), impulse, 1e-9 * impulse);
    }
}

}  // namespace
}  // namespace sherd
