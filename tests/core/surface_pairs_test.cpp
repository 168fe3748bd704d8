// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of bodies must meet edges, and nothing may pass through anything because it is fast.
#include "core/contact/bodies/surface_pairs.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/time/implicit_stepper.h"
#include "tests/support/obstacles.h"
#include "tests/support/plates.h"
#include "tests/support/steps.h"

namespace sherd::test {
namespace {

RigidBody solid_body(const Vector3d& size, const Vector3d& centre, double density = 2000) {
    RigidBody box = rigid_box(size, density);
    box.surface = box_surface(Vector3d::Zero(), 0.5 * size);
    box.centre = centre;
    box.friction = 0.3;
    return box;
}

RigidBody fast_ball(const Vector3d& centre, const Vector3d& velocity) {
    RigidBody ball = rigid_sphere(0.0025, 7850);
    ball.surface = sphere_surface(0.0025, 2);
    ball.centre = centre;
    ball.velocity = velocity;
    return ball;
}

/// A long box, edge up: its upper edge is along y at height zero.
Obstacle roof(double x) {
    const double half = 0.01;
    Obstacle roof = solid_box(Vector3d::Zero(), Vector3d(half, 0.03, half), 3e10, 0.3);
    roof.motion.place.linear() =
        Eigen::AngleAxisd(std::numbers::pi / 4, Vector3d::UnitY()).toRotationMatrix();
    roof.motion.place.translation() = Vector3d(x, 0, -std::sqrt(2.0) * half);
    return roof;
}

/// Steps, halved where they cannot be made, until `duration` s are over; false if that does not help.
bool run(ImplicitStepper& time_step, double step, double duration) {
    double length = step;
    for (double time = 0; time < duration * (1 - 1e-9);) {
        if (time_step.begin(length) && time_step.solve(50).converged) {
            time_step.finish();
            time += length;
            length = std::min(2 * length, step);
        } else if ((length /= 2) < step / 4096) {
            return false;
        }
    }
    return true;
}

// Two edges of a box across two edges of obstacles, far from any corner: by corners alone it falls through.
TEST(SurfacePairs, EdgesOnEdgesCarryABox) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-3;
    options.contact.obstacles = {roof(-0.03), roof(0.03)};
    options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.01), Vector3d(0, 0, 0.0055))};
    ImplicitStepper time_step(shell, options);
    ASSERT_TRUE(run(time_step, 1e-3, 0.4));
    const RigidBody& body = time_step.bodies()[0];
    EXPECT_NEAR(body.centre.z(), 0.005, 1e-4);
    EXPECT_LT(body.velocity.norm(), 1e-3);
    EXPECT_LT((body.rotation - Matrix3d::Identity()).norm(), 1e-3);
    EXPECT_EQ(time_step.touch().obstacles.size(), 2u);
}

// The same of free boxes on each other: a cross of two logs on a floor.
TEST(SurfacePairs, CrossedBoxesRest) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-3;
    options.contact.obstacles = {floor(3e10, 0.5)};
    options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.02), Vector3d(0, 0, 0.01)),
                              solid_body(Vector3d(0.02, 0.1, 0.02), Vector3d(0.003, 0.002, 0.0305))};
    ImplicitStepper time_step(shell, options);
    ASSERT_TRUE(run(time_step, 1e-3, 0.4));
    EXPECT_NEAR(time_step.bodies()[0].centre.z(), 0.01, 1e-4);
    EXPECT_NEAR(time_step.bodies()[1].centre.z(), 0.03, 2e-4);
    for (const RigidBody& body : time_step.bodies()) EXPECT_LT(body.velocity.norm(), 1e-3);
}

// Fast balls pass neither each other nor a thin wall, and keep momentum.
TEST(SurfacePairs, FastBallsDoNotPassEachOther) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    shell.velocity.setZero();
    StepperOptions options;
    options.step = 1e-4;
    options.gravity.setZero();
    options.tolerance = 1e-12;
    options.contact.bodies = {fast_ball(Vector3d(-0.03, 0, 0), Vector3d(1000, 0, 0)),
                              fast_ball(Vector3d(0.03, 0, 0), Vector3d(-1000, 0, 0))};
    ImplicitStepper time_step(shell, options);
    ASSERT_TRUE(run(time_step, 1e-4, 1e-4));
    const std::vector<RigidBody>& bodies = time_step.bodies();
    EXPECT_LT(bodies[0].centre.x(), bodies[1].centre.x());
    EXPECT_LT((bodies[0].velocity + bodies[1].velocity).norm(), 1e-5);
    EXPECT_LT(bodies[0].velocity.x(), 100) << "it was stopped";
}

TEST(SurfacePairs, AFastBallDoesNotPassAThinWall) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-4;
    options.gravity.setZero();
    options.contact.obstacles = {solid_box(Vector3d::Zero(), Vector3d(5e-5, 0.1, 0.1))};
    options.contact.bodies = {fast_ball(Vector3d(-0.03, 0, 0), Vector3d(1000, 0, 0))};
    ImplicitStepper time_step(shell, options);
    ASSERT_TRUE(run(time_step, 1e-4, 1e-4));
    EXPECT_LT(time_step.bodies()[0].centre.x(), 0);
}

// An obstacle that comes up under boxes takes them along: else no step could be begun.
TEST(SurfacePairs, AMovingObstacleLiftsAStack) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-3;
    Obstacle table = solid_box(Vector3d(0, 0, -0.01), Vector3d(0.1, 0.1, 0.01), 3e10, 0.3);
    table.motion.keys = {MotionKey{}, MotionKey{.time = 0.2, .translation = Vector3d(0, 0, 0.1)}};
    options.contact.obstacles = {table};
    options.contact.bodies = {solid_body(Vector3d(0.06, 0.05, 0.02), Vector3d(0, 0, 0.01)),
                              solid_body(Vector3d(0.05, 0.04, 0.02), Vector3d(0.001, 0.002, 0.03))};
    ImplicitStepper time_step(shell, options);
    ASSERT_TRUE(run(time_step, 1e-3, 0.1));
    EXPECT_NEAR(time_step.bodies()[0].centre.z(), 0.06, 5e-4);
    EXPECT_NEAR(time_step.bodies()[1].centre.z(), 0.08, 5e-4);
}

}  // namespace
}  // namespace sherd::test
