// SPDX-License-Identifier: GPL-3.0-or-later
// Length of explicit substeps where damping limits it. If it were too long, a damped sheet would diverge; if
// it were so short that substeps are countless, a run would seem to hang.
#include "core/time/stable_substep.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/time/explicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

// Damping by the medium uses the velocity before the substep: in a longer substep it would take more than
// the momentum, and throw the sheet back, ever faster.
TEST(StableSubstep, StrongDampingByTheMediumStopsASheet) {
    Shell shell = test::stacked_plates(1, 3, 0, test::glass);
    shell.velocity.row(2).setConstant(-3);
    StepperOptions options;
    options.scheme = Scheme::explicit_differences;
    options.step = 2e-6;
    options.gravity.setZero();
    options.shell.damping.mass = 1e8;
    ExplicitStepper stepper(shell, options);
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(stepper.begin());
        ASSERT_TRUE(stepper.solve(1));
        stepper.finish();
    }
    EXPECT_LT(shell.velocity.cwiseAbs().maxCoeff(), 1e-9);
}

// Where damping is 1e9 times too large, the substep must not become zero by cancellation.
TEST(StableSubstep, IsThatOfTheTheory) {
    EXPECT_DOUBLE_EQ(stable_substep(1e6, {}, 2e-6, 0.8), 0.8 * 2e-6);
    EXPECT_DOUBLE_EQ(stable_substep(1e6, {1.5e-6, 0}, 2e-6, 0.8), 0.8 * 2e-6 * 0.5);
    EXPECT_DOUBLE_EQ(stable_substep(1e6, {0, 1e8}, 2e-6, 0.8), 0.8 * 2e-8);
    EXPECT_NEAR(stable_substep(1e6, {1e3, 0}, 1e-12, 0.8), 0.8 * 2e-6 / 1e9, 1e-20);
}

// Substeps too short for any run must end with an error that tells the cause, not with hours of computing.
TEST(StableSubstep, WhatCannotBeCountedIsAnErrorThatSaysHowShortTheyWouldBe) {
    try {
        stable_substep(1e6, {0, 1e15}, 2e-6, 0.8);
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_NE(std::string(error.what()).find("would need substeps of 1.6e-15 s"), std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace sherd
