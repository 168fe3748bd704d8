// SPDX-License-Identifier: GPL-3.0-or-later
// Forces of the air. Each test is a statement of aerodynamics that must hold for a flag in the wind.
#include "core/forces/wind.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "core/time/implicit_stepper.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

const Material card{.density = 500, .thickness = 4e-3, .young = 1e8, .poisson = 0.3};

double area_of(const Shell& shell) {
    double sum = 0;
    for (const TriangleStencil& triangle : shell.triangles) sum += triangle.membrane.area;
    return sum;
}

Wind wind_on(const Shell& shell, const Vector3d& velocity) {
    Wind wind;
    wind.velocity = velocity;
    wind.triangles.resize(shell.triangles.size());
    std::iota(wind.triangles.begin(), wind.triangles.end(), 0);
    return wind;
}

/// Forces of the air, N, on a sheet that keeps its velocity.
Positions forces(const Shell& shell, const Wind& wind, double step = 1e-3) {
    Positions gradient = Positions::Zero(3, shell.position.cols());
    test::begun(WindEnergy(shell, {wind}), shell, 1 - step, step)
        .add_gradient(shell.position + step * shell.velocity, gradient);
    return -gradient;
}

/// Total force, N, on a flat sheet in the plane z = 0.
Vector3d total_force(const Vector3d& velocity, const Vector3d& air = Vector3d::Zero()) {
    Shell shell = test::two_triangles(card);
    shell.velocity.colwise() = velocity;
    return forces(shell, wind_on(shell, air)).rowwise().sum();
}

Shell moving_anyhow() {
    Shell shell = test::tetrahedron(card);
    test::Random random(3);
    for (double& entry : shell.velocity.reshaped()) entry = random.uniform(-5, 5);
    for (double& entry : shell.position.reshaped()) entry += random.uniform(-0.2, 0.2);
    return shell;
}

// With wrong derivatives Newton's method would not converge, or would take steps uphill.
TEST(Wind, GradientAndHessianAreDerivativesOfAConvexEnergy) {
    const Shell shell = moving_anyhow();
    const WindEnergy energy =
        test::begun(WindEnergy(shell, {wind_on(shell, {4, -2, 1})}), shell, 1 - 1e-2, 1e-2);
    test::expect_derivatives(energy, shell.position, 1e-3, 1e-8);
    BlockMatrix hessian(4, {}, std::vector<char>(4, 0));
    energy.add_hessian(shell.position, Curvature::exact, hessian);
    EXPECT_GT(test::eigenvalues(test::dense(hessian))[0], 0);
    EXPECT_GE(energy.value(shell.position), 0);
}

TEST(Wind, APlateThatFallsBroadsideReachesItsTerminalSpeed) {
    for (const double length : {1e-2, 1e-1, 0.5}) {
        Shell shell = test::two_triangles(card);
        StepperOptions options;
        options.step = length;
        options.shell.winds = {wind_on(shell, Vector3d::Zero())};
        ImplicitStepper time_step(shell, options);
        for (double time = 0; time < 8; time += length) test::advance(time_step);
        const double speed =
            std::sqrt(2 * shell.mass.sum() * 9.81 / (1.225 * area_of(shell) * options.shell.winds[0].drag));
        for (Index v = 0; v < 4; ++v)
            EXPECT_NEAR(-shell.velocity(2, v), speed, 0.01 * speed) << "step " << length;
        EXPECT_LT(shell.velocity.topRows(2).cwiseAbs().maxCoeff(), 1e-3 * speed) << "it slips sideways";
    }
}

TEST(Wind, ExertsNoForceOnWhatMovesWithIt) {
    Shell shell = test::tetrahedron(card);
    const Vector3d velocity(3, 4, -2);
    shell.velocity.colwise() = velocity;
    EXPECT_LT(forces(shell, wind_on(shell, velocity)).norm(), 1e-12);
    EXPECT_GT(forces(shell, wind_on(shell, -velocity)).norm(), 1);
}

TEST(Wind, OnASheetAtRestIsASheetThatMovesThroughStillAir) {
    const Vector3d velocity(6, 1, -3);
    Shell resting = test::tetrahedron(card), moving = resting;
    moving.velocity.colwise() = -velocity;
    StepperOptions options;
    options.step = 2e-3;
    options.tolerance = 1e-12;
    StepperOptions still = options;
    options.shell.winds = {wind_on(resting, velocity)};
    still.shell.winds = {wind_on(moving, Vector3d::Zero())};
    ImplicitStepper in_wind(resting, options), in_still_air(moving, still);
    for (int i = 1; i <= 50; ++i) {
        test::advance(in_wind);
        test::advance(in_still_air);
        const Positions seen = moving.position.colwise() + i * options.step * velocity;
        ASSERT_LT((seen - resting.position).cwiseAbs().maxCoeff(), 1e-9);
    }
    EXPECT_GT(linear_momentum(resting).norm(), 0.1) << "nothing was blown: the test proves nothing";
}

TEST(Wind, EdgeOnOnlyFrictionIsLeft) {
    const double pressure = 0.5 * 1.225 * 49 * area_of(test::two_triangles(card));
    EXPECT_LT((total_force({7, 0, 0}) - Vector3d(-0.02 * pressure, 0, 0)).norm(), 1e-12);
    EXPECT_LT((total_force({0, 0, 0}, {0, 7, 0}) - Vector3d(0, 0.02 * pressure, 0)).norm(), 1e-12);
    EXPECT_LT((total_force({0, 0, -7}) - Vector3d(0, 0, 1.2 * pressure)).norm(), 1e-12)
        << "and broadside drag";
}

// A sheet that climbs at a small angle has lift: the force normal to the flow.
TEST(Wind, LiftsWhatIsAtAnAngleToIt) {
    const double angle = 0.1, pressure = 0.5 * 1.225 * 100 * area_of(test::two_triangles(card));
    const Vector3d direction(std::cos(angle), 0, std::sin(angle));
    const Vector3d force = total_force(Vector3d::Zero(), 10 * direction);
    const double normal = 1.2 * std::sin(angle) * std::sin(angle) + 1.5 * std::sin(angle) * std::cos(angle);
    EXPECT_NEAR(force.z(), normal * pressure, 1e-12 * pressure);
    EXPECT_NEAR(force.x(), 0.02 * std::cos(angle) * std::cos(angle) * pressure, 1e-12 * pressure);
    const double lift = force.dot(Vector3d(-std::sin(angle), 0, std::cos(angle)));
    EXPECT_NEAR(lift / (pressure * angle), 1.5, 0.15);
    EXPECT_LT((total_force(-10 * direction) - force).norm(), 1e-12);
}

// Large coefficients and steps must take a sheet to the wind's speed, and never beyond.
TEST(Wind, NeverBlowsASheetFasterThanItself) {
    for (const double step : {1e-4, 1e-2, 1.0}) {
        Shell shell = test::tetrahedron(card);
        StepperOptions options;
        options.gravity.setZero();
        options.step = step;
        Wind wind = wind_on(shell, {20, 0, 0});
        wind.drag = wind.lift = wind.friction = 1e5;
        options.shell.winds = {wind};
        ImplicitStepper time_step(shell, options);
        double before = 0.5 * shell.mass.sum() * 400;
        for (int i = 0; i < 20; ++i) {
            test::advance(time_step);
            Shell seen = shell;
            seen.velocity.colwise() -= wind.velocity;
            const double energy =
                kinetic_energy(seen) + time_step.energies().membrane + time_step.energies().bending;
            EXPECT_LE(energy, before * (1 + 1e-9));
            before = energy;
        }
        if (step == 1.0) {
            EXPECT_LT((linear_momentum(shell) / shell.mass.sum() - wind.velocity).norm(), 0.2);
        }
    }
}

TEST(Wind, GrowsOverItsRampAndGustsAreWaves) {
    Wind wind;
    wind.velocity = {2, 0, 0};
    wind.ramp = 4;
    EXPECT_EQ(wind.at({0, 0, 0}, 1), Vector3d(0.5, 0, 0));
    EXPECT_EQ(wind.at({5, 6, 7}, 9), Vector3d(2, 0, 0));
    wind.ramp = 0;
    EXPECT_EQ(wind.at({0, 0, 0}, 0), Vector3d(2, 0, 0));
    using std::numbers::pi;
    wind.gusts = {{{0, 3, 0}, {pi, 0, 0}, 2 * pi, pi / 2}};
    EXPECT_LT((wind.at({0, 0, 0}, 0) - Vector3d(2, 0, 0)).norm(), 1e-14);
    EXPECT_LT((wind.at({0.5, 9, 9}, 0) - Vector3d(2, -3, 0)).norm(), 1e-14);
    EXPECT_LT((wind.at({0.5, 0, 0}, 0.5) - Vector3d(2, 3, 0)).norm(), 1e-14);
}

}  // namespace
}  // namespace sherd
