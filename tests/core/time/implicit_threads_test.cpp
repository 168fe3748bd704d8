// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

/// Positions, velocities, energy lost to the scheme and number of iterations of three plates that fall onto
/// each other and onto a box.
auto falling_plates(Method method, BendingModel bending, int threads) {
    Shell shell = test::stacked_plates(3, 12, 1.001 * test::glass.thickness, test::glass);
    shell.position.row(2).array() += 0.501 * test::glass.thickness;
    shell.velocity.row(2).setConstant(-2);
    shell.velocity.row(0).setConstant(1);
    StepperOptions options;
    options.method = method;
    options.step = 2e-5;
    options.threads = threads;
    options.shell.bending.model = bending;
    options.contact.sheets = true;
    options.contact.friction = 0.2;
    options.contact.obstacles = {test::solid_box({0, 0, -0.02}, {0.02, 0.03, 0.02}, 3e10, 0.3)};
    ImplicitStepper stepper(shell, options);
    int iterations = 0;
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(stepper.begin());
        const StepResult result = stepper.solve(100);
        EXPECT_TRUE(result) << i;
        iterations += result.iterations;
        stepper.finish();
    }
    EXPECT_GT(stepper.balance().lost_to_friction, 0) << "they have not met";
    return std::tuple(shell.position, shell.velocity, stepper.balance().lost_to_scheme, iterations);
}

// A run must not depend on the number of cores.
TEST(ImplicitThreads, AnyNumberOfThemGivesTheSameBits) {
    for (const auto& [method, bending] : {std::pair(Method::quasi_newton, BendingModel::coupled),
                                          std::pair(Method::newton, BendingModel::nonlinear)}) {
        const auto alone = falling_plates(method, bending, 1);
        EXPECT_TRUE(falling_plates(method, bending, 2) == alone);
    }
}

}  // namespace
}  // namespace sherd
