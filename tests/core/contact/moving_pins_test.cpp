// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that a motion carries: if they were late, or without their velocity, a flag would not follow its
// pole, nor a shaken plate its shaker.
#include <gtest/gtest.h>

#include <numbers>

#include "core/time/implicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

using std::numbers::pi;

Motion straight(const Vector3d& way, double duration) {
    Motion motion;
    motion.smooth = false;
    motion.keys = {{0}, {duration, way}};
    return motion;
}

/// Pins the vertices and lets the motion carry them.
void carry(Shell& shell, const std::vector<Index>& vertices, const Motion& motion) {
    shell.motions.push_back(motion);
    for (const Index v : vertices) {
        shell.fixed[v] = 1;
        shell.script[v] = static_cast<Index>(shell.motions.size());
    }
}

TEST(MovingPins, AreWhereTheMotionHasThemWithItsVelocity) {
    Shell shell = test::stacked_plates(1, 4, 0, test::thin_rubber);
    Motion motion;
    motion.keys = {{0.01}, {0.05, Vector3d(0, 0.02, 0.01), Vector3d::UnitX(), pi / 2}};
    motion.pivot = shell.rest.col(0);
    carry(shell, {0, 1, 7}, motion);
    shell.fixed[20] = 1;
    StepperOptions options;
    options.step = 2e-3;
    options.tolerance = 1e-9;
    ImplicitStepper time_step(shell, options);
    for (int i = 1; i <= 30; ++i) {
        const Positions before = shell.position;
        test::advance(time_step);
        for (const Index v : {0, 1, 7}) {
            const Vector3d place = motion.at(i * options.step) * Vector3d(shell.rest.col(v));
            EXPECT_LT((shell.position.col(v) - place).norm(), 1e-15);
            EXPECT_LT((shell.velocity.col(v) * options.step - (place - before.col(v))).norm(), 1e-15);
        }
        EXPECT_EQ(shell.position.col(20), shell.rest.col(20));
    }
    EXPECT_GT((shell.position.col(7) - shell.rest.col(7)).norm(), 0.02) << "nothing moved";
}

// For an observer at the same velocity, moving pins are at rest: the sheet must move as with pins at rest.
TEST(MovingPins, AtConstantVelocityDoWhatPinsAtRestDo) {
    const Vector3d velocity(3, -2, 1);
    Shell standing = test::stacked_plates(1, 6, 0, test::thin_rubber), flying = standing;
    standing.fixed[0] = standing.fixed[6] = 1;
    carry(flying, {0, 6}, straight(velocity, 1));
    flying.velocity.colwise() = velocity;
    StepperOptions options;
    options.step = 2e-3;
    options.tolerance = 1e-12;
    ImplicitStepper still(standing, options), moving(flying, options);
    for (int i = 1; i <= 40; ++i) {
        test::advance(still);
        test::advance(moving);
        const Positions seen = flying.position.colwise() - i * options.step * velocity;
        ASSERT_LT((seen - standing.position).cwiseAbs().maxCoeff(), 1e-9) << "step " << i;
    }
    EXPECT_GT((standing.position - standing.rest).norm(), 0.01) << "nothing swings: the test proves nothing";
    EXPECT_LT((linear_momentum(flying) - linear_momentum(standing) - flying.mass.sum() * velocity).norm(),
              1e-7);
}

// A clamp that turns must turn the sheet's tangent: in the end the whole sheet has moved rigidly with the
// clamp.
TEST(MovingPins, AClampThatTurnsTurnsTheSheet) {
    Material stiff = test::thin_rubber;
    stiff.young *= 1000;
    Shell shell = test::stacked_plates(1, 4, 0, stiff);
    Motion motion;
    motion.keys = {{0}, {0.1, Vector3d(0, 0, 0.1), Vector3d::UnitX(), pi / 2}};
    motion.pivot = shell.rest.col(2);
    carry(shell, {0, 1, 2, 3, 4}, motion);
    StepperOptions options;
    options.gravity.setZero();
    options.step = 2e-3;
    options.shell.damping.mass = 100;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, shell.fixed))
        options.shell.mirrors.push_back(clamp_hinge(shell, side, hinge_stiffness(stiff)));
    ASSERT_EQ(options.shell.mirrors.size(), 4u);
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < 400; ++i) test::advance(time_step);
    const Positions turned = motion.at(1) * shell.rest;
    EXPECT_LT((shell.position - turned).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(time_step.energies().bending, 1e-9);
}

// A plate that is carried into a free plate must arrive in time, and throw the free plate ahead.
TEST(MovingPins, PushWhatIsInTheirWay) {
    Shell shell = test::stacked_plates(2, 3, 1.2e-3, test::thin_rubber);
    const Index half = static_cast<Index>(shell.rest.cols()) / 2;
    std::vector<Index> lower(half);
    for (Index v = 0; v < half; ++v) lower[v] = v;
    carry(shell, lower, straight(Vector3d(0, 0, 0.1), 0.1));
    shell.velocity.rightCols(half).row(2).setConstant(-0.3);
    StepperOptions options;
    options.gravity.setZero();
    options.contact.sheets = true;
    options.step = 2e-4;
    options.tolerance = 1e-8;
    ImplicitStepper time_step(shell, options);
    for (int i = 1; i <= 50; ++i) {
        test::advance(time_step);
        EXPECT_NEAR(shell.position(2, 0), i * options.step, 1e-15);
        EXPECT_GT(test::smallest_distance(shell, shell.position), 0.75 * test::thin_rubber.thickness);
    }
    EXPECT_GT(shell.velocity.rightCols(half).row(2).mean(), 1);
    // In a long step the pins move too far: the step must be refused, not solved with the pins half-way or
    // through the other plate.
    Shell near = test::stacked_plates(2, 3, 1.2e-3, test::thin_rubber);
    carry(near, lower, straight(Vector3d(0, 0, 0.1), 0.1));
    options.step = 5e-3;
    EXPECT_FALSE(ImplicitStepper(near, options).begin());
}

}  // namespace
}  // namespace sherd
