// SPDX-License-Identifier: GPL-3.0-or-later
// BDF2 is compared with known motions: with a wrong weight, or a history that does not follow changes of the
// shell, it would be of first order, or drift.

#include <gtest/gtest.h>

#include <cmath>

#include "core/shell/inheritance.h"
#include "core/time/schemes/bdf2.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd::test {
namespace {

StepperOptions bdf2(double step) {
    StepperOptions options;
    options.scheme = Scheme::bdf2;
    options.step = step;
    options.gravity.setZero();
    options.tolerance = 1e-12;
    return options;
}

void advance_by(ImplicitStepper& stepper, double length) {
    ASSERT_TRUE(stepper.begin(length));
    ASSERT_TRUE(stepper.solve(200));
    stepper.finish();
}

/// Error, m, of the position of a lone vertex after 0.1 s in a resisting medium, x' = u exp(-c t). Long and
/// short steps alternate, with the ratio `uneven`.
double miss_in_a_medium(int steps, double uneven) {
    Shell shell = lone_vertex(Vector3d::Zero());
    shell.velocity.col(0) = Vector3d(2, 0, 0);
    const double rate = 20, mean = 0.1 / steps;
    StepperOptions options = bdf2(mean);
    options.shell.damping.mass = rate;
    ImplicitStepper stepper(shell, options);
    for (int i = 0; i < steps / 2; ++i) {
        const double longer = 2 * mean * uneven / (1 + uneven);
        advance_by(stepper, longer);
        advance_by(stepper, 2 * mean - longer);
    }
    return std::abs(shell.position(0, 0) - 2 / rate * (1 - std::exp(-rate * 0.1)));
}

// Half the step must give a quarter of the error, also where steps differ in length, as after one that was
// halved.
TEST(Bdf2, IsOfSecondOrderWithStepsOfAnyLength) {
    for (const double uneven : {1.0, 2.0}) {
        const double once = miss_in_a_medium(40, uneven), twice = miss_in_a_medium(80, uneven);
        EXPECT_GT(once / twice, 3.4) << uneven;
        EXPECT_LT(once / twice, 4.6) << uneven;
        EXPECT_LT(once, 2e-4);
    }
}

/// Rotation of a tumbling brick after 0.05 s, and the relative change of its angular momentum.
std::pair<Matrix3d, double> tumbled(int steps) {
    Shell shell = lone_vertex({1, 0, 0});
    RigidBody brick = rigid_box({0.05, 0.03, 0.01}, 2000);
    brick.angular_momentum = Vector3d(1, 20, 0.5) * 2e-5;
    StepperOptions options = bdf2(0.05 / steps);
    options.contact.bodies = {brick};
    ImplicitStepper stepper(shell, options);
    for (int i = 0; i < steps; ++i) advance_by(stepper, options.step);
    const RigidBody& end = stepper.bodies()[0];
    return {end.rotation,
            (end.angular_momentum - brick.angular_momentum).norm() / brick.angular_momentum.norm()};
}

// The angular velocity of a body with different moments of inertia changes without torque; the error of its
// rotation must be of second order, too.
TEST(Bdf2, BodiesTumbleAtSecondOrder) {
    const auto [truth, none] = tumbled(3200);
    const auto [once, lost] = tumbled(200);
    const auto [twice, lost_less] = tumbled(400);
    const double ratio = (once - truth).norm() / (twice - truth).norm();
    EXPECT_GT(ratio, 3.3);
    EXPECT_LT(ratio, 4.7);
    EXPECT_LT(lost, 1e-12);
}

// A vertex that a crack splits has a copy with the same history: uniform motion must remain uniform.
TEST(Bdf2, InsertedVerticesHaveThePastOfTheirParents) {
    Shell shell = stacked_plates(1, 3, 0, {1000, 0.01, 1e8, 0.2});
    shell.velocity.colwise() = Vector3d(3, -1, 2);
    ImplicitStepper stepper(shell, bdf2(1e-3));
    for (int i = 0; i < 3; ++i) advance_by(stepper, 1e-3);
    ASSERT_TRUE(stepper.begin(0.7e-3));
    Shell other = shell;
    Bdf2 scheme;
    StepContext step = scheme.begin(other, {}, 0, 1e-3);
    scheme.finish(step, step.origin + step.lag * step.velocity_origin, other);
    step = scheme.begin(other, {}, 1e-3, 0.7e-3);
    const auto last = static_cast<Index>(other.mass.size());
    ShellChange change;
    change.vertices = {{last, {{last - 1, 1}}}};
    for (Positions* columns : {&other.position, &other.velocity}) append(*columns, change.vertices);
    other.mass.conservativeResize(last + 1);
    other.mass[last] = other.mass[last - 1] /= 2;
    scheme.topology_changed(other, change, step);
    ASSERT_EQ(step.origin.cols(), last + 1);
    EXPECT_EQ(step.origin.col(last), step.origin.col(last - 1));
    const Positions ahead = other.position + 0.7e-3 * other.velocity;
    EXPECT_LT((step.velocity(ahead) - other.velocity).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((step.acceleration(ahead)).cwiseAbs().maxCoeff(), 1e-6);
}

/// A plate that spins and vibrates in steps of changing length.
class Bdf2Flight : public testing::Test {
  protected:
    void SetUp() override {
        for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v) {
            const Vector3d at = shell.position.col(v);
            shell.velocity.col(v) = Vector3d(1, 0, 3).cross(at);
            shell.velocity(2, v) += 2 * std::cos(40 * at.x());
        }
        start = kinetic_energy(shell);
        spin = angular_momentum(shell);
        ImplicitStepper stepper(shell, bdf2(1e-4));
        for (int i = 0; i < 100; ++i) advance_by(stepper, i % 3 == 0 ? 1e-4 : 0.6e-4);
        balance = stepper.balance();
        end = kinetic_energy(shell) + stepper.energies().stored();
    }

    Shell shell = stacked_plates(1, 6, 0, {1000, 0.002, 1e8, 0.2});
    double start = 0, end = 0;
    Vector3d spin;
    EnergyBalance balance;
};

// Numerical dissipation has a formula for each scheme; a wrong one would leave an energy residual.
TEST_F(Bdf2Flight, TheBalanceExplainsIt) {
    EXPECT_LT(std::abs(balance.unexplained), 1e-9 * start);
    EXPECT_NEAR(end, start - balance.lost_to_scheme, 1e-9 * start);
}

TEST_F(Bdf2Flight, KeepsItsSpinAndDampsFastVibration) {
    const double turned = (angular_momentum(shell) - spin).norm() / spin.norm(), taken = 1 - end / start;
    EXPECT_LT(turned, 0.01);
    EXPECT_GT(taken, 3e-4);
    EXPECT_LT(taken, 0.9);
}

}  // namespace
}  // namespace sherd::test
