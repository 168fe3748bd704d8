// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/time/explicit_stepper.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

/// Positions, velocities and the balance of a damped plate that was thrown at a box and slides on it.
auto thrown_plate(int threads) {
    Shell shell = test::stacked_plates(1, 40, 0, test::glass);
    shell.position.row(2).array() += 2.001e-3;
    shell.velocity.row(2).setConstant(-3);
    shell.velocity.row(0).setConstant(1);
    StepperOptions options;
    options.scheme = Scheme::explicit_differences;
    options.step = 2e-6;
    options.threads = threads;
    options.shell.damping = {.stiffness = 1e-8, .mass = 1};
    options.contact.obstacles = {test::solid_box({0, 0, -0.02}, {0.02, 0.03, 0.02}, 3e10, 0.3)};
    ExplicitStepper stepper(shell, options);
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(stepper.begin());
        EXPECT_TRUE(stepper.solve(1));
        stepper.finish();
    }
    EXPECT_GT(stepper.balance().lost_to_friction, 0) << "they have not met";
    return std::tuple(shell.position, shell.velocity, stepper.balance().lost_to_damping,
                      stepper.balance().lost_to_scheme, stepper.balance().unexplained);
}

// A run must not depend on the number of cores.
TEST(ExplicitThreads, AnyNumberOfThemGivesTheSameBits) {
    const auto alone = thrown_plate(1);
    EXPECT_TRUE(thrown_plate(2) == alone);
    EXPECT_TRUE(thrown_plate(3) == alone);
}

}  // namespace
}  // namespace sherd
