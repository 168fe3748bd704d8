// SPDX-License-Identifier: GPL-3.0-or-later
// Where an obstacle's corners and edges meet the faces of a sheet, or an obstacle is thinner than the motion
// in a step, contact at the sheet's vertices alone would let the obstacle through.
#include <gtest/gtest.h>

#include "core/contact/colliders/contact_colliders.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/time/implicit_stepper.h"
#include "tests/support/contact/collider_gap.h"
#include "tests/support/contact/friction_of_motion.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd::test {
namespace {

StepperOptions against(const Obstacle& obstacle, double step) {
    StepperOptions options;
    options.step = step;
    options.gravity.setZero();
    options.contact.obstacles = {obstacle};
    options.tolerance = 1e-8;
    return options;
}

/// Advances by `count` steps; fails unless each step can be solved and leaves a gap of 5 % of `thickness`
/// (m).
void advance(Shell& shell, const StepperOptions& options, int count, double thickness) {
    ImplicitStepper time_step(shell, options);
    for (int i = 1; i <= count; ++i) {
        ASSERT_TRUE(time_step.begin()) << "step " << i;
        ASSERT_TRUE(time_step.solve(200)) << "step " << i;
        time_step.finish();
        ASSERT_GT(gap(shell, options.contact.obstacles[0], i * options.step), 0.05 * thickness)
            << "step " << i;
    }
}

/// Box that stands on one of its corners, which is at the origin.
Obstacle spike(double friction = 0) {
    const double half = 0.02;
    Obstacle box = solid_box(Vector3d::Zero(), Vector3d::Constant(half), 3e10, friction);
    box.motion.place.linear() = test::onto_a_corner();
    box.motion.place.translation() = Vector3d(0, 0, -std::sqrt(3.0) * half);
    return box;
}

// The corner and the edges of a box under faces: a wrong derivative would push the sheet wrongly or keep the
// solver from converging.
TEST(ColliderContact, ForceAndStiffnessAreDerivativesOfTheValue) {
    Shell shell = stacked_plates(1, 2, 0, firm_rubber);
    shell.position.colwise() += Vector3d(0.011, 0.007, 0.2 * firm_rubber.thickness);
    Obstacle moving = spike(0.4);
    moving.motion.keys = {{.time = 1}, {.time = 1 + 1e-3, .translation = Vector3d(2e-5, 0, 0)}};
    SheetContact contact(shell, {moving}, false);
    contact.begin(test::step_of(shell, 0, 1e-3));
    ASSERT_GT(contact.active_pairs(shell.position).size(), 0u);
    expect_derivatives(contact, shell.position, 1e-9, 1e-4);

    expect_friction_along_x(shell, contact, test::step_of(shell, 1, 1e-3));
}

// The corner of a box fits between the vertices of a coarse plate, where only contact with faces stops it.
TEST(ColliderContact, ACornerDoesNotPassThroughAFace) {
    Shell shell = stacked_plates(1, 2, 0, firm_rubber);
    shell.position.colwise() += Vector3d(0.011, 0.007, 0.004);
    shell.velocity.row(2).setConstant(-10);
    advance(shell, against(spike(), 1e-4), 40, firm_rubber.thickness);
    EXPECT_GT(linear_momentum(shell).z(), -0.9 * 10 * shell.mass.sum()) << "it felt the corner";
}

// In one step at 1 km/s the plate would end far behind the wall.
TEST(ColliderContact, AThinWallStopsAPlateAtAKilometreASecond) {
    Shell shell = stacked_plates(1, 4, 0, ceramic);
    shell.position.row(2).array() += 0.05;
    shell.velocity.row(2).setConstant(-1000);
    const Obstacle wall = solid_box(Vector3d::Zero(), Vector3d(0.2, 0.2, 5e-5));
    advance(shell, against(wall, 1e-4), 5, ceramic.thickness);
    EXPECT_GT(shell.position.row(2).minCoeff(), 0);
    EXPECT_GT(linear_momentum(shell).z(), 0) << "thrown back";
}

// A thin box must take along a plate in its path, although it moves by many of its thicknesses in a step.
TEST(ColliderContact, AMovingWallTakesAPlateAlong) {
    Shell shell = stacked_plates(1, 4, 0, firm_rubber);
    shell.position.row(2).array() += 0.003;
    Obstacle wall = solid_box(Vector3d::Zero(), Vector3d(0.2, 0.2, 5e-5));
    wall.motion.smooth = false;
    wall.motion.keys = {{0, Vector3d::Zero(), Vector3d::UnitZ(), 0},
                        {1, Vector3d(0, 0, 20), Vector3d::UnitX(), 0.3}};
    advance(shell, against(wall, 1e-3), 20, firm_rubber.thickness);
    EXPECT_GT(shell.velocity.row(2).mean(), 15);
}

// Contact with the box's surface must not add to the springs at the sheet's vertices: a plate must sink
// equally deep into a box with a surface and into one without, which has springs alone, like a plane.
TEST(ColliderContact, APlateLiesOnABoxAsOnAPlane) {
    double depth[2];
    for (const bool surface : {false, true}) {
        Shell shell = stacked_plates(1, 4, 0, firm_rubber);
        shell.position.row(2).array() += 0.5 * firm_rubber.thickness;
        Obstacle box = solid_box(Vector3d(0, 0, -1), Vector3d(1, 1, 1));
        if (!surface) box.surface = nullptr;
        StepperOptions options = against(box, 1e-2);
        options.gravity = Vector3d(0, 0, -9.81);
        options.tolerance = 1e-13;
        ImplicitStepper time_step(shell, options);
        for (int i = 0; i < 100; ++i) {
            time_step.begin();
            time_step.solve(50);
            time_step.finish();
        }
        depth[surface] = 0.5 * firm_rubber.thickness - shell.position.row(2).mean();
    }
    EXPECT_GT(depth[0], 0);
    EXPECT_NEAR(depth[1], depth[0], 1e-2 * depth[0]);
}

// A sheet that is pinned inside a box, near its surface, must hang from the box freely; the rest of the
// sheet must collide with the box.
TEST(ColliderContact, WhatIsHeldInsideDoesNotMeetItsHolder) {
    Shell shell = stacked_plates(1, 8, 0, firm_rubber);
    const Obstacle holder = solid_box(Vector3d(-0.06, 0, 0), Vector3d(0.0105, 0.2, 0.01));
    for (Index v = 0; v < static_cast<Index>(shell.rest.cols()); ++v)
        shell.fixed[v] = shell.rest(0, v) < -0.044;
    StepperOptions options = against(holder, 1e-3);
    options.gravity = Vector3d(0, 0, -9.81);
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(time_step.begin());
        ASSERT_TRUE(time_step.solve(100));
        time_step.finish();
    }
    EXPECT_LT(shell.position.row(2).minCoeff(), -5e-3) << "it hangs";
}

// Substeps must be short enough for an approaching obstacle: a wall that met a plate at rest within a step
// once threw it off with too much energy.
TEST(ColliderContact, ExplicitStepsTouchAMovingWallInTime) {
    for (const bool surface : {false, true}) {
        Shell shell = stacked_plates(1, 4, 0, firm_rubber);
        shell.position.row(2).array() += 0.6 * firm_rubber.thickness;
        Obstacle wall = solid_box(Vector3d(0, 0, -0.01), Vector3d(0.2, 0.2, 0.01));
        if (!surface) wall.surface = nullptr;
        wall.motion.smooth = false;
        wall.motion.keys = {{0}, {1, Vector3d(0, 0, 0.5)}};
        StepperOptions options = against(wall, 2e-3);
        options.scheme = Scheme::explicit_differences;
        const std::unique_ptr<Stepper> stepper = make_stepper(shell, options);
        for (int i = 0; i < 10; ++i) {
            ASSERT_TRUE(stepper->begin());
            stepper->solve(1);
            stepper->finish();
        }
        EXPECT_GT(shell.velocity.row(2).mean(), 0.4);
        EXPECT_LT(shell.velocity.row(2).mean(), 1.05) << "faster than an elastic blow makes it";
        EXPECT_LT(std::abs(stepper->balance().lost_to_scheme), 0.01 * shell.mass.sum() * 0.25);
    }
}

}  // namespace
}  // namespace sherd::test
