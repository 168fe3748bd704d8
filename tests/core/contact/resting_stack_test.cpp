// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/contact/penalty/obstacle_contact.h"
#include "core/time/implicit_stepper.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

constexpr int plates = 3;
constexpr double settling = 0.5, rest = 10;  // s, time to come to rest, and time at rest

void advance(ImplicitStepper& time_step, double seconds, double step) {
    for (int i = 0; i < std::lround(seconds / step); ++i) {
        time_step.begin();
        ASSERT_TRUE(time_step.solve(50));
        time_step.finish();
    }
}

// Fragments at rest must stay at rest: a stack on the floor drifts by less than a millionth of its size in 10
// s, and each plate and the floor bear the weight above them to 1 %.
TEST(RestingStack, StaysAtRest) {
    Shell shell = test::stacked_plates(plates, 3, 1.001 * test::ceramic.thickness, test::ceramic);
    shell.position.row(2).array() += 0.5001 * test::ceramic.thickness;
    const Obstacle floor = test::floor(3e10, 0.3);
    StepperOptions options;
    options.step = 5e-3;
    options.contact.obstacles = {floor};
    options.contact.sheets = true;
    options.contact.friction = 0.3;
    options.tolerance = 2e-10;  // m, a hundredth of the overlap of the plates
    ImplicitStepper time_step(shell, options);
    advance(time_step, settling, options.step);
    const Positions before = shell.position;
    advance(time_step, rest, options.step);
    EXPECT_LT((shell.position - before).colwise().norm().maxCoeff(), 1e-6 * 0.1);

    Positions forces = Positions::Zero(3, shell.position.cols());
    test::begun(ObstacleContact(shell, floor), shell, settling + rest, options.step)
        .add_gradient(shell.position, forces);
    const double weight = 9.81 * shell.mass.sum();
    EXPECT_NEAR(-forces.row(2).sum(), weight, 0.01 * weight);
    forces.setZero();
    SheetContact(shell).add_gradient(shell.position, forces);
    const Index each = static_cast<Index>(shell.position.cols()) / plates;
    for (int plate = 1; plate < plates; ++plate) {
        const Index above = (plates - plate) * each;
        const double load = 9.81 * shell.mass.tail(above).sum();
        EXPECT_NEAR(-forces.rightCols(above).row(2).sum(), load, 0.01 * load) << "on plate " << plate - 1;
    }
}

/// Largest displacement, m, in `rest` of plates that lie on each other on a slope of 10 degrees.
double creep(Scheme scheme) {
    Shell shell = test::stacked_plates(plates, 2, 1.001 * test::ceramic.thickness, test::ceramic);
    shell.position.row(2).array() += 0.5001 * test::ceramic.thickness;
    const Eigen::AngleAxisd tilt(10 * std::numbers::pi / 180, Vector3d::UnitY());
    shell.position = tilt.toRotationMatrix() * shell.position;
    const Obstacle ramp = test::obstacle(PlaneShape(Vector3d::Zero(), tilt * Vector3d::UnitZ()), 3e10, 0.3);
    StepperOptions options;
    options.scheme = scheme;
    options.step = 5e-3;
    options.contact.obstacles = {ramp};
    options.contact.sheets = true;
    options.contact.friction = 0.3;
    options.tolerance = 2e-10;
    ImplicitStepper time_step(shell, options);
    advance(time_step, settling, options.step);
    const Positions before = shell.position;
    advance(time_step, rest, options.step);
    return (shell.position - before).colwise().norm().maxCoeff();
}

// A stack on a slope must not creep if friction can hold it. With BDF2, which hardly damps vibration, it may
// move ten times as far.
TEST(RestingStack, StaysOnASlope) {
    EXPECT_LT(creep(Scheme::implicit_euler), 1e-6 * 0.1);
    EXPECT_LT(creep(Scheme::bdf2), 1e-5 * 0.1);
}

}  // namespace
}  // namespace sherd
