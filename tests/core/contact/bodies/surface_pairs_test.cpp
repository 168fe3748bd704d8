// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of bodies must collide with edges, by forces that keep momentum and do not increase the energy. Fast
// bodies must not pass through each other or through obstacles.
#include "core/contact/bodies/surface_pairs.h"

#include <gtest/gtest.h>

#include "core/contact/bodies/body_contact.h"
#include "core/time/implicit_stepper.h"
#include "tests/support/contact/free_boxes.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd::test {
namespace {

RigidBody fast_ball(const Vector3d& centre, const Vector3d& velocity) {
    RigidBody ball = rigid_sphere(0.0025, 7850);
    ball.surface = sphere_surface(0.0025, 2);
    ball.centre = centre;
    ball.velocity = velocity;
    return ball;
}

/// Advances for `duration` s in steps of `step` s. A step that fails is halved; returns false if it becomes
/// too short.
bool run(ImplicitStepper& time_step, double step, double duration) {
    double length = step;
    for (double time = 0; time < duration * (1 - 1e-9);) {
        if (time_step.begin(length) && time_step.solve(50)) {
            time_step.finish();
            time += length;
            length = std::min(2 * length, step);
        } else if ((length /= 2) < step / 4096) {
            return false;
        }
    }
    return true;
}

// A box lies across the top edges of two roofs, far from any corner: with contact at corners alone, the box
// would fall through.
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

// Two long free boxes lie across each other on a floor; the upper box touches the lower one with edges only.
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

// Two fast balls that meet head-on must not pass through each other, and must keep momentum.
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

// An edge of a small box hits an edge of a long box, with no corner of the long box nearby. Without contact,
// the small box would move by 0.1 m in the step, and be beyond the long box, which is 0.014 m wide.
TEST(SurfacePairs, AFastBoxDoesNotPassAnEdge) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-4;
    options.gravity.setZero();
    RigidBody small = solid_body(Vector3d(0.005, 0.005, 0.005), Vector3d(-0.03, 0.0003, 0));
    small.rotation = turn_about(Vector3d::UnitY());
    small.velocity = Vector3d(1000, 0, 0);
    RigidBody log = solid_body(Vector3d(0.01, 0.01, 0.2), Vector3d(0.01, 0, 0.013));
    log.rotation = turn_about(Vector3d::UnitZ());
    options.contact.bodies = {small, log};
    ImplicitStepper time_step(shell, options);
    ASSERT_TRUE(run(time_step, 1e-4, 1e-4));
    const std::vector<RigidBody>& bodies = time_step.bodies();
    EXPECT_LT(bodies[0].velocity.x(), 990) << "they have met";
    EXPECT_LT((small.mass * (bodies[0].velocity - small.velocity) + log.mass * bodies[1].velocity).norm(),
              1e-6 * small.mass * 1000);
    const Vector3d beside = bodies[1].rotation.transpose() * (bodies[0].centre - bodies[1].centre);
    EXPECT_GT(std::max(std::abs(beside.x()), std::abs(beside.y())), 0.005) << "it is not inside";
}

// A long box lies with an edge on a soft plate, and a second one moves down onto it, edge on edge: the second
// box presses on the plate through the first.
TEST(SurfacePairs, ForceAndStiffnessAreDerivativesOfTheValue) {
    Material soft;
    soft.density = 1000, soft.thickness = 0.002, soft.young = 1e7;
    Shell shell = stacked_plates(1, 8, 0, soft);
    shell.velocity.setZero();
    const double size = 0.01, half = size / std::sqrt(2.0);
    RigidBody lower = solid_body(Vector3d(0.06, size, size), Vector3d(0, 0, 0.00047 + half));
    // Both boxes must not be parallel to edges of the plate's mesh.
    const Eigen::AngleAxisd askew(0.3, Vector3d::UnitZ());
    lower.rotation = askew * turn_about(Vector3d::UnitX());
    RigidBody upper = solid_body(Vector3d(size, 0.06, size), lower.centre + Vector3d(2e-3, 1e-3, 2 * half));
    upper.rotation = askew * turn_about(Vector3d::UnitY());
    upper.velocity = Vector3d(0.004, 0.002, -0.01);
    upper.angular_momentum = upper.inertia.cwiseProduct(Vector3d(0.2, 0, 0.4));
    for (const double friction : {0.0, 0.3}) {
        lower.friction = upper.friction = friction;
        shell.position = shell.rest;
        const std::vector<RigidBody> bodies{lower, upper};
        const std::vector<Obstacle> none;
        BodyContact contact(shell, bodies, none, Vector3d::Zero());
        contact.begin(test::step_of(shell, 0, 1e-3, bodies));
        const auto press = [&] {
            Positions columns = contact.place();
            columns.col(2) += Vector3d(4e-6, 2e-6, -3e-5);
            contact.place(columns);
        };
        press();
        // The boxes touch at the end of this step; friction acts from the next step on.
        contact.finish(shell.position);
        contact.begin(test::step_of(shell, 1e-3, 1e-3, contact.bodies()));
        press();
        Touch touch;
        contact.add_touch(shell.position, touch);
        ASSERT_EQ(touch.bodies.size(), 2u);
        ASSERT_FALSE(touch.vertices.empty());
        Random random(2);
        Positions x = contact.with_bodies(shell.position);
        for (double& entry : x.reshaped()) entry += 1e-6 * random.uniform(-1, 1);
        // The tolerance is large because the Hessian is a Gauss-Newton approximation.
        expect_derivatives(contact, x, 1e-9, 5e-2);
        Positions gradient = Positions::Zero(3, x.cols());
        contact.add_gradient(x, gradient);
        for (int i = 0; i < 10; ++i) {
            Positions d(3, x.cols());
            for (double& entry : d.reshaped()) entry = random.uniform(-1e-9, 1e-9);
            EXPECT_NEAR(gradient.cwiseProduct(d).sum(), 0.5 * (contact.value(x + d) - contact.value(x - d)),
                        1e-5 * gradient.norm() * d.norm());
        }
    }
}

struct Meeting {
    Scheme scheme;
    double friction;
};
class MeetingEdges : public testing::TestWithParam<Meeting> {};
INSTANTIATE_TEST_SUITE_P(SurfacePairs, MeetingEdges,
                         testing::Values(Meeting{Scheme::implicit_euler, 0},
                                         Meeting{Scheme::implicit_euler, 0.3}, Meeting{Scheme::bdf2, 0},
                                         Meeting{Scheme::bdf2, 0.3}));

// Two boxes that collide in flight, edge on edge, must keep their total momentum, and their energy must not
// grow.
TEST_P(MeetingEdges, KeepsMomentumAndMakesNoEnergy) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    shell.velocity.setZero();
    StepperOptions options;
    options.scheme = GetParam().scheme;
    options.step = 2e-6;  // the collision lasts several steps, so that friction acts in it
    options.gravity.setZero();
    options.tolerance = 1e-13;
    RigidBody one = solid_body(Vector3d(0.1, 0.02, 0.02), Vector3d(0, 0, 0));
    RigidBody other = solid_body(Vector3d(0.02, 0.1, 0.02), Vector3d(0.01, 0.015, 0.0287));
    one.rotation = turn_about(Vector3d::UnitX());
    other.rotation = turn_about(Vector3d::UnitY());
    other.velocity = Vector3d(0.3, 0.2, -2);
    one.friction = other.friction = GetParam().friction;
    options.contact.bodies = {one, other};
    const Vector6d before = momenta(options.contact.bodies);
    const double energy = kinetic(options.contact.bodies);
    ImplicitStepper time_step(shell, options);
    // Angular momentum lost to implicit Euler; for BDF2 an upper bound on the loss.
    Vector3d lost = Vector3d::Zero();
    for (int i = 0; i < 500; ++i) {
        const std::vector<RigidBody> start = time_step.bodies();
        advance(time_step);
        for (std::size_t b = 0; b < start.size(); ++b)
            lost += options.step * start[b].mass * time_step.bodies()[b].velocity.cross(start[b].velocity);
        const double now = kinetic(time_step.bodies()) + time_step.energies().contact;
        ASSERT_LT(now, energy * (1 + (GetParam().scheme == Scheme::bdf2 ? 1e-2 : 1e-9))) << "step " << i;
    }
    const Vector6d after = momenta(time_step.bodies());
    EXPECT_GT(time_step.bodies()[0].velocity.norm(), 0.5) << "it was hit";
    EXPECT_GT(time_step.bodies()[1].velocity.z(), time_step.bodies()[0].velocity.z()) << "they part";
    EXPECT_LT((after - before).head<3>().norm(), 1e-9 * before.head<3>().norm());
    EXPECT_LT((after - before).tail<3>().norm(), 1e-3 * before.tail<3>().norm() + lost.norm());
    EXPECT_LT(std::abs(time_step.balance().unexplained), 1e-6 * energy);
    EXPECT_EQ(time_step.balance().lost_to_friction > 0, GetParam().friction > 0);
}

// A box falls with an edge on the top edge of a roof, which it hits away from its middle. It must tip over
// and fall off, and its energy must only decrease.
TEST(SurfacePairs, ABoxRollsOffAnEdge) {
    for (const double friction : {0.0, 0.4}) {
        Shell shell = lone_vertex(Vector3d(5, 5, 5));
        shell.velocity.setZero();
        StepperOptions options;
        options.step = 5e-4;
        options.tolerance = 1e-12;
        options.contact.obstacles = {roof(0)};
        RigidBody box = solid_body(Vector3d(0.06, 0.02, 0.02), Vector3d(0.008, 0.001, 0.02));
        box.rotation = turn_about(Vector3d::UnitX());
        box.friction = friction;
        options.contact.bodies = {box};
        ImplicitStepper time_step(shell, options);
        const auto energy = [&] {
            const RigidBody& now = time_step.bodies()[0];
            return now.kinetic_energy() + now.mass * 9.81 * now.centre.z() + time_step.energies().contact;
        };
        const double before = energy();
        double last = before;
        for (int i = 0; i < 300; ++i) {
            ASSERT_TRUE(run(time_step, options.step, options.step)) << "step " << i;
            ASSERT_LT(energy(), last + 1e-9 * before) << "step " << i;
            last = energy();
        }
        const RigidBody& now = time_step.bodies()[0];
        EXPECT_LT(now.centre.z(), 0.005) << "it has tipped, or fallen";
        EXPECT_GT((now.rotation - box.rotation).norm(), 0.3) << "it turned as it fell: the edge was there";
        EXPECT_LT(std::abs(time_step.balance().unexplained), 1e-6 * before);
    }
}

// Two boxes whose edges cross at the start, deeply or slightly, with no corner of one box in the other, must
// move freely until they are apart, and collide from then on. A barrier would lock them into each other, or
// throw them apart.
TEST(SurfacePairs, WhatCrossesAtTheStartMeetsOnceItIsApart) {
    for (const double depth : {0.005, 1.5e-4}) {
        Shell shell = lone_vertex(Vector3d(5, 5, 5));
        StepperOptions options;
        // The step is short, so that a force that throws the boxes apart would act for several steps.
        options.step = 2e-5;
        options.gravity.setZero();
        RigidBody up = solid_body(Vector3d(0.02, 0.1, 0.02), Vector3d(0.003, 0.002, 0.02 - depth));
        up.velocity = Vector3d(0, 0, 1);
        options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.02), Vector3d::Zero()), up};
        ImplicitStepper time_step(shell, options);
        ASSERT_TRUE(run(time_step, options.step, 0.01));
        EXPECT_NEAR(time_step.bodies()[1].centre.z(), 0.03 - depth, 1e-6) << depth;
        EXPECT_LT(time_step.bodies()[0].velocity.norm(), 1e-9) << depth;

        options.contact.bodies = time_step.bodies();
        options.contact.bodies[1].velocity.z() = -1;
        ImplicitStepper back(shell, options);
        ASSERT_TRUE(run(back, 1e-3, 0.03));
        EXPECT_GT(back.bodies()[1].centre.z() - back.bodies()[0].centre.z(), 0.0199) << depth;
    }
}

// An obstacle that moves up under two stacked boxes must take them along: if the boxes stayed, the obstacle
// would enter them, and no step could begin.
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
