// SPDX-License-Identifier: GPL-3.0-or-later
// In a collision that is too strong for the springs of explicit contact, surfaces must not pass through each
// other, and the stiffer springs that stop them must keep momentum and energy.
#include <gtest/gtest.h>

#include "core/time/explicit_stepper.h"
#include "tests/support/contact/free_boxes.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd::test {
namespace {

StepperOptions long_steps() {
    StepperOptions options;
    options.scheme = Scheme::explicit_differences;
    options.step = 2e-4;
    options.gravity.setZero();
    return options;
}

/// Makes `steps` steps. Returns the shortest substep over the longest one.
double advance(ExplicitStepper& stepper, int steps) {
    double shortest = 1, longest = 0;
    for (int i = 0; i < steps; ++i) {
        EXPECT_TRUE(stepper.begin());
        EXPECT_TRUE(stepper.solve(1));
        stepper.finish();
        shortest = std::min(shortest, stepper.substep());
        longest = std::max(longest, stepper.substep());
    }
    return shortest / longest;
}

// Plates collide at three times the speed of sound in rubber, where the springs, which are columns of
// rubber, store only a tenth of the energy.
TEST(SecondSprings, PlatesThatOverwhelmSpringsExchangeTheirVelocity) {
    Shell shell = stacked_plates(2, 4, 4e-3, rubber);
    const Index half = static_cast<Index>(shell.mass.size()) / 2;
    shell.velocity.setZero();
    shell.velocity.rightCols(half).row(2).setConstant(-150);
    StepperOptions options = long_steps();
    options.contact.sheets = true;
    ExplicitStepper stepper(shell, options);
    const Vector3d momentum = linear_momentum(shell);
    const double kinetic = kinetic_energy(shell);
    EXPECT_LT(advance(stepper, 3), 0.2) << "the springs were not overwhelmed";
    EXPECT_LT((linear_momentum(shell) - momentum).norm(), 1e-11 * momentum.norm());
    EXPECT_LT(shell.velocity.leftCols(half).row(2).mean(), shell.velocity.rightCols(half).row(2).mean() - 50);
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 0.02 * kinetic);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-10 * kinetic);
}

// A light and a heavy box. Firm springs throw the light one back faster than they would a vertex of the
// sheet.
TEST(SecondSprings, ABoxThatOverwhelmsSpringsIsThrownBack) {
    for (const double density : {10.0, 20000.0}) {
        Shell shell = stacked_plates(1, 4, 0, rubber);
        shell.velocity.setZero();
        StepperOptions options = long_steps();
        options.contact.bodies = {
            solid_body(Vector3d::Constant(0.02), Vector3d(0.004, 0.003, 0.0202), density)};
        RigidBody& box = options.contact.bodies[0];
        box.rotation = turn_about(Vector3d(1, 0.3, 0.1).normalized());
        box.velocity = Vector3d(0, 0, -40);
        const double momentum = box.mass * 40, kinetic = box.kinetic_energy();
        ExplicitStepper stepper(shell, options);
        EXPECT_LT(advance(stepper, 4), 0.2) << "the springs were not overwhelmed";
        const RigidBody& now = stepper.bodies()[0];
        EXPECT_NEAR(linear_momentum(shell).z() + now.mass * now.velocity.z(), -momentum, 1e-9 * momentum);
        EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 0.02 * kinetic);
        EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-10 * kinetic);
    }
}

}  // namespace
}  // namespace sherd::test
