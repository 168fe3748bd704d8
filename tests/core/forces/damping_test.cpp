// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/damping.h"

#include <gtest/gtest.h>

#include "core/membrane/membrane_energy.h"
#include "core/time/implicit_stepper.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

/// Vibration modes of a sheet at rest.
test::Modes modes(const Shell& shell, BendingModel model) {
    const std::unique_ptr<Energy> bending = bending_energy(shell, {model, exact_jacobian(model)});
    const MembraneEnergy membrane(shell.triangles);
    std::vector<std::pair<Index, Index>> pairs;
    bending->add_pattern(pairs);
    membrane.add_pattern(pairs);
    BlockMatrix stiffness(static_cast<Index>(shell.mass.size()), pairs, shell.fixed);
    bending->add_hessian(shell.rest, Curvature::exact, stiffness);
    membrane.add_hessian(shell.rest, Curvature::exact, stiffness);
    const VectorXd mass = shell.mass.transpose().replicate(3, 1).reshaped();
    return test::modes_of(test::dense(stiffness), mass);
}

// Each mode, of angular frequency w, must decay as implicit Euler's difference equation says, with the step
// h and the coefficients a of mass and b of stiffness:
//     (1 + h a + h b w^2 + h^2 w^2) q_{n+1} = (2 + h a + h b w^2) q_n - q_{n-1}.
class DampingOf : public testing::TestWithParam<BendingModel> {};
INSTANTIATE_TEST_SUITE_P(Models, DampingOf, testing::Values(BendingModel::cubic, BendingModel::coupled));

TEST_P(DampingOf, EveryModeDecaysAtTheRateOfTheTwoCoefficients) {
    const Shell rest = test::two_triangles(test::thick_foam);
    const auto eigen = modes(rest, GetParam());
    for (int mode = 6; mode < 12; ++mode) {
        Shell shell = rest;
        const double w = std::sqrt(eigen.squares[mode]);
        const double h = 0.2 / w;
        const VectorXd u = eigen.vectors.col(mode);
        const double amplitude = 1e-6 / u.cwiseAbs().maxCoeff();
        shell.position += amplitude * u.reshaped(3, 4);
        StepperOptions options;
        options.gravity.setZero();
        options.step = h;
        options.tolerance = 1e-14;
        options.shell.damping = {0.05 / w, 0.3 * w};
        options.shell.bending = {GetParam(), exact_jacobian(GetParam())};
        const double viscous = h * (options.shell.damping.mass + options.shell.damping.stiffness * w * w);
        ImplicitStepper step(shell, options);
        double before = amplitude, now = amplitude;
        for (int i = 0; i < 20; ++i) {
            test::advance(step);
            const double next = ((2 + viscous) * now - before) / (1 + viscous + h * h * w * w);
            before = std::exchange(now, next);
            const VectorXd moved = (shell.position - shell.rest).reshaped();
            const VectorXd mass = shell.mass.transpose().replicate(3, 1).reshaped();
            EXPECT_NEAR(u.dot(mass.asDiagonal() * moved), now, 1e-5 * amplitude) << "mode " << mode;
        }
    }
}

// With wrong derivatives Newton's method would not converge, or would find another solution.
TEST(Damping, GradientAndHessianAreDerivatives) {
    Shell shell = test::tetrahedron(test::thick_foam);
    test::Random random(1);
    for (double& entry : shell.position.reshaped()) entry += random.uniform(-0.1, 0.1);
    Positions x = shell.position;
    for (double& entry : x.reshaped()) entry += random.uniform(-0.2, 0.2);
    StiffnessDamping stiffness(shell, 0.01);
    stiffness.begin(test::step_of(shell, 0, 1e-3));
    test::expect_derivatives(stiffness, x, 1e-4, 1e-7);
    StiffnessDamping arcs(shell, 0.01, BendingModel::coupled, MembraneModel::arc);
    arcs.begin(test::step_of(shell, 0, 1e-3));
    EXPECT_LT(arcs.value(shell.position), 1e-12 * arcs.value(x)) << "rest itself was damped";
    test::expect_derivatives(arcs, x, 1e-4, 1e-7);
    test::expect_derivatives(test::begun(MassDamping(shell, 3), shell, 0, 1e-3), x, 1e-4, 1e-7);
}

// A viscous force must neither push nor turn a sheet as a whole, however the sheet is deformed.
TEST(Damping, StiffnessDampingHasNoNetForceNorTorque) {
    Shell shell = test::tetrahedron(test::thick_foam);
    test::Random random(2);
    for (double& entry : shell.position.reshaped()) entry += random.uniform(-0.3, 0.3);
    Positions x = shell.position;
    for (double& entry : x.reshaped()) entry += random.uniform(-0.3, 0.3);
    StiffnessDamping damping(shell, 0.01);
    damping.begin(test::step_of(shell, 0, 1e-3));
    Positions force = Positions::Zero(3, 4);
    damping.add_gradient(x, force);
    Vector3d torque = Vector3d::Zero();
    for (Index v = 0; v < 4; ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
    EXPECT_GT(force.norm(), 0);
    EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
    EXPECT_LT(torque.norm(), 1e-12 * force.norm());
    // A rigid rotation during the step has no energy.
    const Positions turned = random.rotation() * shell.position;
    EXPECT_LT(damping.value(turned), 1e-10 * damping.value(x));
}

// In a sheet that spins and vibrates with damping, the vibration must decay while linear momentum and
// rotation are kept.
TEST(Damping, StiffnessDampingKeepsLinearMomentumAndRotation) {
    Shell shell = test::tetrahedron(test::thick_foam);
    const Vector3d spin(1, 2, -1);
    for (Index v = 0; v < 4; ++v)
        shell.velocity.col(v) = Vector3d(1, 0, 0.5) + spin.cross(Vector3d(shell.position.col(v)));
    shell.velocity(0, 1) += 1;
    StepperOptions options;
    options.gravity.setZero();
    options.step = 1e-4;
    options.shell.damping.stiffness = 1e-3;
    const Vector3d linear = linear_momentum(shell), angular = angular_momentum(shell);
    ImplicitStepper step(shell, options);
    for (int i = 0; i < 500; ++i) test::advance(step);
    EXPECT_LT((linear_momentum(shell) - linear).norm(), 1e-9 * linear.norm());
    EXPECT_LT((angular_momentum(shell) - angular).norm(), 2e-3 * angular.norm());
}

// Mass damping by the coefficient a must slow a free flight by (1 + h a) v_{n+1} = v_n in steps of h.
TEST(Damping, MassDampingSlowsFreeFlight) {
    Shell shell = test::two_triangles(test::thick_foam);
    shell.velocity.colwise() = Vector3d(1, 2, 3);
    StepperOptions options;
    options.gravity.setZero();
    options.step = 0.01;
    options.shell.damping.mass = 4;
    const Vector3d start = linear_momentum(shell);
    ImplicitStepper step(shell, options);
    for (int i = 1; i <= 10; ++i) {
        test::advance(step);
        EXPECT_LT((linear_momentum(shell) - start / std::pow(1.04, i)).norm(), 1e-9 * start.norm());
    }
}

// The last correction of a step, which conserves momentum, must account for mass damping of any strength.
TEST(Damping, StrongMassDampingLeavesTheSpeedAtWhichItBearsTheWeight) {
    Shell shell = test::two_triangles(test::thick_foam);
    shell.velocity.colwise() = Vector3d(0, 0, -3);
    StepperOptions options;
    options.gravity = Vector3d(0, 0, -10);
    options.step = 1e-3;
    options.shell.damping.mass = 1e6;
    ImplicitStepper step(shell, options);
    double speed = 3;
    for (int i = 0; i < 5; ++i) {
        test::advance(step);
        speed = (speed + options.step * 10) / (1 + options.step * options.shell.damping.mass);
        EXPECT_LT((shell.velocity.colwise() - Vector3d(0, 0, -speed)).cwiseAbs().maxCoeff(), 1e-6 * speed)
            << i;
    }
}

}  // namespace
}  // namespace sherd
