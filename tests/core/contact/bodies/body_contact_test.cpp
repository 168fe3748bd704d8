// SPDX-License-Identifier: GPL-3.0-or-later
// Free bodies must exchange momentum with sheets and with each other, pass through none of them, and come to
// rest on sheets and obstacles.
#include "core/contact/bodies/body_contact.h"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "core/time/implicit_stepper.h"
#include "tests/support/contact/collider_gap.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd::test {
namespace {

Material elastic() {
    Material material;
    material.density = 1000, material.thickness = 0.002, material.young = 1e7;
    return material;
}

RigidBody ball(const Vector3d& centre, const Vector3d& velocity) {
    RigidBody ball = rigid_sphere(0.02, 1500);
    ball.centre = centre;
    ball.velocity = velocity;
    ball.friction = 0.3;
    return ball;
}

Vector3d momentum(const Shell& shell, const RigidBody& body) {
    return linear_momentum(shell) + body.mass * body.velocity;
}

Vector3d spin_momentum(const Shell& shell, const RigidBody& body) {
    return angular_momentum(shell) + body.mass * body.centre.cross(body.velocity) + body.angular_momentum;
}

// Returns the unknowns for the shell at x and the bodies where they are placed, each changed at random by up
// to `distance` (m).
Positions near_to(const BodyContact& contact, const Positions& x, double distance) {
    Random random(2);
    Positions all = contact.with_bodies(x);
    for (double& entry : all.reshaped()) entry += distance * random.uniform(-1, 1);
    return all;
}

TEST(BodyContact, ForceAndStiffnessAreDerivativesOfTheValue) {
    Shell shell = stacked_plates(1, 8, 0, elastic());
    shell.velocity.setZero();
    RigidBody box = rigid_box(Vector3d(0.05, 0.04, 0.02), 800);
    box.rotation = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 0).normalized()).toRotationMatrix();
    box.centre = Vector3d(0.001, 0.002, 0.018);
    box.angular_momentum = Vector3d(1e-4, 2e-4, 0);
    RigidBody spike = box;
    spike.centre.z() = 0.0197;
    spike.surface = box_surface(Vector3d::Zero(), Vector3d(0.025, 0.02, 0.01));
    for (const RigidBody& body : {ball(Vector3d(0.003, 0.001, 0.0208), Vector3d(0.1, 0, -1)), box, spike}) {
        const std::vector<Obstacle> none;
        BodyContact contact(shell, {body}, none, Vector3d::Zero());
        contact.begin(test::step_of(shell, 0, 1e-3, {body}));
        contact.predict(shell.position);
        ASSERT_GT(contact.stored_energy(shell.position), 0);
        // The tolerance is large because the Hessian is a Gauss-Newton approximation.
        expect_derivatives(contact, near_to(contact, shell.position, 1e-5), 1e-9,
                           body.inertia[0] == body.inertia[1] ? 2e-2 : 5e-2);
        BodyInertia inertia(&contact);
        inertia.begin(test::step_of(shell, 0, 1e-3, {body}));
        expect_derivatives(inertia, near_to(contact, shell.position, 1e-3), 1e-6, 1e-6);
    }
}

// A body that is smaller than a face of the sheet and moves far in a step must not pass through the sheet
// between its vertices.
TEST(BodyContact, NoBodyPassesThroughAFace) {
    for (const bool is_ball : {false, true}) {
        Shell shell = stacked_plates(1, 2, 0, elastic());
        RigidBody body = is_ball ? rigid_sphere(0.004, 1500) : rigid_box(Vector3d(0.006, 0.004, 0.005), 1500);
        body.surface = is_ball ? sphere_surface(0.004, 3)
                               : box_surface(Vector3d::Zero(), Vector3d(0.003, 0.002, 0.0025));
        body.centre = Vector3d(0.011, 0.007, 0.012);
        body.velocity = Vector3d(0, 0, -300);
        body.angular_momentum = body.inertia.cwiseProduct(Vector3d(500, 300, 0));
        body.friction = 0.3;
        StepperOptions options;
        options.step = 1e-4;
        options.gravity.setZero();
        options.tolerance = 1e-12;
        options.contact.bodies = {body};
        const Vector3d before = momentum(shell, body);
        ImplicitStepper time_step(shell, options);
        for (int i = 0; i < 20; ++i) {
            ASSERT_TRUE(time_step.begin());
            ASSERT_TRUE(time_step.solve(200)) << "step " << i;
            time_step.finish();
            const RigidBody& now = time_step.bodies()[0];
            Obstacle solid;
            solid.surface = now.surface;
            solid.motion.place = now.pose();
            ASSERT_GT(gap(shell, solid, 0), 0.05 * 0.002) << "step " << i;
            ASSERT_LT((momentum(shell, now) - before).norm(), 1e-8 * before.norm()) << "step " << i;
        }
        EXPECT_LT(linear_momentum(shell).z(), 0.1 * before.z()) << "the sheet was pushed";
    }
}

// A small body that moves in a step much farther than its size must not get beyond a sheet: neither around
// the sheet's rim, nor by a failed collision search, nor through a face. A step that cannot be solved is
// halved, as in a run; the loop ends when steps become too short, where a run would end with an error.
TEST(BodyContact, NoBodyIsBeyondASheetHoweverFast) {
    struct Shot {
        double speed;  // m/s
        int squares, fineness;
    };
    for (const auto& [speed, squares, fineness] : {Shot{1e3, 4, 1}, {2e3, 4, 1}, {5e3, 8, 3}}) {
        Shell shell = stacked_plates(1, squares, 0, elastic());
        RigidBody body = rigid_sphere(0.0025, 7850);
        body.surface = sphere_surface(0.0025, fineness);
        body.centre = Vector3d(0.003, 0.001, 0.05);
        body.velocity = Vector3d(0, 0, -speed);
        StepperOptions options;
        options.step = 1e-4;
        options.gravity.setZero();
        options.contact.bodies = {body};
        const double before = momentum(shell, body).z();
        ImplicitStepper time_step(shell, options);
        bool touched = false;
        int steps = 0;
        for (double length = options.step; length > 5e-6 && steps < 30; ++steps) {
            if (!time_step.begin(length) || !time_step.solve(8)) {
                length /= 2;
                continue;
            }
            touched |= !time_step.touch().vertices.empty();
            time_step.finish();
            const RigidBody& now = time_step.bodies()[0];
            ASSERT_NEAR(momentum(shell, now).z(), before, 1e-6 * std::abs(before));
            // The plate does not fracture: where the ball pushes it, it goes down with the ball. So the
            // ball's height is compared with the plate's lowest vertex.
            const double below = shell.position.row(2).minCoeff();
            ASSERT_GT(now.centre.z(), below) << speed << " m/s, step " << steps;
            if (touched && now.velocity.z() > -0.5 * speed) break;
        }
        EXPECT_TRUE(touched || steps > 0) << speed << " m/s";
    }
}

void step(ImplicitStepper& time_step, int count) {
    for (int i = 0; i < count; ++i) {
        time_step.begin();
        EXPECT_TRUE(time_step.solve(50));
        time_step.finish();
    }
}

// Without friction, the collision keeps angular momentum to 1e-8; with friction, to 1e-5 only, because the
// friction forces on the ball and on the sheet act at two points a small distance apart.
class Collision : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(BodyContact, Collision, testing::Values(0.0, 0.3));

TEST_P(Collision, KeepsMomentum) {
    Shell shell = stacked_plates(1, 10, 0, elastic());
    shell.velocity.setZero();
    StepperOptions options;
    options.step = 1e-4;
    options.gravity.setZero();
    options.tolerance = 1e-12;
    options.contact.bodies = {ball(Vector3d(0.004, -0.003, 0.0212), Vector3d(1, 0, -5))};
    options.contact.bodies[0].friction = GetParam();
    options.contact.bodies[0].angular_momentum = Vector3d(0, 1e-3, 2e-3);
    const Vector3d before = momentum(shell, options.contact.bodies[0]);
    const Vector3d turning = spin_momentum(shell, options.contact.bodies[0]);
    ImplicitStepper time_step(shell, options);
    std::size_t touched = 0;
    // Angular momentum lost to implicit Euler, as in free flight: the sum of h m v' x v over vertices and
    // body, with the velocities v before and v' after a step of length h.
    Vector3d lost = Vector3d::Zero();
    for (int i = 0; i < 60; ++i) {
        const Positions velocity = shell.velocity;
        const RigidBody start = time_step.bodies()[0];
        step(time_step, 1);
        for (Eigen::Index v = 0; v < velocity.cols(); ++v)
            lost += options.step * shell.mass[v] *
                    Vector3d(shell.velocity.col(v)).cross(Vector3d(velocity.col(v)));
        lost += options.step * start.mass * time_step.bodies()[0].velocity.cross(start.velocity);
        touched = std::max(touched, time_step.touch().vertices.size());
        const RigidBody& body = time_step.bodies()[0];
        ASSERT_LT((momentum(shell, body) - before).norm(), 1e-8 * before.norm()) << "step " << i;
    }
    const RigidBody& body = time_step.bodies()[0];
    EXPECT_GT(touched, 3u);
    EXPECT_GT(linear_momentum(shell).z(), -before.norm());
    EXPECT_LT(linear_momentum(shell).z(), -0.05 * before.norm()) << "the sheet was pushed";
    EXPECT_LT((spin_momentum(shell, body) - turning - lost).norm(),
              (GetParam() > 0 ? 1e-5 : 1e-8) * turning.norm());
    EXPECT_LT(lost.norm(), 0.02 * turning.norm());
}

// When a free body turns about an axis that is not a principal axis, the axis changes, but the angular
// momentum must not.
TEST(BodyContact, AFreeBodyFallsAndKeepsItsAngularMomentum) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-3;
    RigidBody box = rigid_box(Vector3d(0.1, 0.2, 0.3), 1000);
    box.angular_momentum = Vector3d(0.1, 0.2, 0.3);
    options.contact.bodies = {box};
    ImplicitStepper time_step(shell, options);
    step(time_step, 1000);
    const RigidBody& moved = time_step.bodies()[0];
    EXPECT_LT((moved.angular_momentum - box.angular_momentum).norm(), 1e-12);
    EXPECT_NEAR(moved.centre.z(), -0.5 * 9.81 * (1 + 1e-3), 1e-9);
    EXPECT_GT((moved.spin() - box.spin()).norm(), 0.1 * box.spin().norm()) << "it tumbles";
}

// A ball and a box that are dropped on a floor must come to rest on it.
TEST(BodyContact, BodiesRestOnObstacles) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-3;
    options.contact.obstacles = {floor()};
    options.contact.bodies = {ball(Vector3d(0, 0, 0.021), Vector3d::Zero()),
                              rigid_box(Vector3d(0.1, 0.1, 0.04), 1000)};
    options.contact.bodies[1].centre = Vector3d(1, 0, 0.021);
    ImplicitStepper time_step(shell, options);
    step(time_step, 1000);
    for (const RigidBody& body : time_step.bodies()) {
        EXPECT_NEAR(body.centre.z(), 0.02, 1e-6);
        EXPECT_LT(body.velocity.norm(), 1e-3);
    }
}

// A box made by rigid_solid() from its volume, its inertia and its vertices must fall tilted, hit a floor,
// and come to rest in the same pose as the box made by rigid_box().
TEST(BodyContact, ASolidOfABoxFallsLikeABox) {
    const Vector3d size(0.04, 0.03, 0.02);
    const auto fallen = [&](RigidBody body) {
        Shell shell = lone_vertex(Vector3d(5, 5, 5));
        StepperOptions options;
        options.step = 1e-3;
        options.contact.obstacles = {floor()};
        body.centre = Vector3d(0, 0, 0.04);
        body.rotation = Eigen::AngleAxisd(0.4, Vector3d(1, 2, 0).normalized()).toRotationMatrix();
        body.angular_momentum = body.inertia_in_space() * Vector3d(3, 0, 2);
        options.contact.bodies = {body};
        ImplicitStepper time_step(shell, options);
        step(time_step, 400);
        return time_step.bodies()[0];
    };
    const RigidBody box = rigid_box(size, 2000);
    RigidBody solid =
        rigid_solid(size.prod(), box.inertia / 2000, box_surface(Vector3d::Zero(), 0.5 * size)->points, 2000);
    solid.shape = box.shape;
    const RigidBody one = fallen(box), other = fallen(solid);
    EXPECT_NEAR(other.centre.z(), 0.01, 1e-6);
    EXPECT_LT((other.centre - one.centre).norm(), 1e-9);
    EXPECT_LT((other.rotation - one.rotation).norm(), 1e-9);
}

// A soft sheet is held at its rim. A ball laid on it must press it down and then be carried by it.
TEST(BodyContact, ASheetCarriesABody) {
    Shell shell = stacked_plates(1, 8, 0, elastic());
    for (Index v = 0; v < static_cast<Index>(shell.rest.cols()); ++v)
        shell.fixed[v] = shell.rest.col(v).cwiseAbs().maxCoeff() > 0.0499;
    StepperOptions options;
    options.step = 5e-3;  // long steps of implicit Euler damp the motion
    options.contact.bodies = {ball(Vector3d(0, 0, 0.0212), Vector3d::Zero())};
    ImplicitStepper time_step(shell, options);
    step(time_step, 200);
    const RigidBody& body = time_step.bodies()[0];
    EXPECT_LT(body.velocity.norm(), 0.02);
    EXPECT_LT(shell.position.row(2).minCoeff(), -1e-4);
    EXPECT_GT(body.centre.z(), 0.01);
}

// Two balls touch each other, and each touches a vertex of the sheet: the Hessian must couple the columns of
// the two balls.
TEST(BodyContact, BodiesThatTouchAreCoupled) {
    Shell shell = stacked_plates(1, 8, 0, elastic());
    shell.velocity.setZero();
    const Vector3d one = shell.position.col(40), other = shell.position.col(43);
    const double deep = 1e-5, radius = 0.5 * (other - one).norm() + deep;
    std::vector<RigidBody> balls;
    const std::vector<Obstacle> none;
    for (const Vector3d& vertex : {one, other}) {
        RigidBody ball = rigid_sphere(radius, 1500);
        ball.friction = 0.3;
        ball.centre = vertex + Vector3d(0, 0, radius + 0.001 - deep);
        ball.velocity = vertex == one ? Vector3d(0, 0, -0.01) : Vector3d(one - other);
        balls.push_back(ball);
    }
    BodyContact contact(shell, balls, none, Vector3d::Zero());
    contact.begin(test::step_of(shell, 0, 1e-3, balls));
    const Positions x = near_to(contact, shell.position, 1e-6);
    std::vector<std::pair<Index, Index>> pairs;
    contact.add_contacts(x, false, pairs);
    EXPECT_TRUE(std::ranges::count(pairs, std::pair(contact.first_column(1), contact.first_column(0))) > 0);
    expect_derivatives(contact, x, 1e-9, 1e-3);
}

// Two balls and a box that collide in the air must keep their total linear and angular momentum, and the
// balls must not overlap afterwards.
TEST(BodyContact, BodiesCollide) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    shell.velocity.setZero();
    StepperOptions options;
    options.step = 1e-5;
    options.gravity.setZero();
    options.tolerance = 1e-12;
    RigidBody box = rigid_box(Vector3d(0.05, 0.04, 0.03), 800);
    box.centre = Vector3d(0.01, 0.0445, 0.005);
    box.velocity = Vector3d(0, -3, 0);
    box.friction = 0.3;
    options.contact.bodies = {ball(Vector3d(-0.0205, 0, 0), Vector3d(2, 0, 0)),
                              ball(Vector3d(0.0205, 0.004, 0), Vector3d::Zero()), box};
    const auto total = [](const std::vector<RigidBody>& bodies) {
        Vector6d sum = Vector6d::Zero();
        for (const RigidBody& body : bodies) {
            sum.head<3>() += body.mass * body.velocity;
            sum.tail<3>() += body.mass * body.centre.cross(body.velocity) + body.angular_momentum;
        }
        return sum;
    };
    const auto before = total(options.contact.bodies);
    ImplicitStepper time_step(shell, options);
    Vector3d lost = Vector3d::Zero();  // angular momentum lost to implicit Euler
    for (int i = 0; i < 1000; ++i) {
        const std::vector<RigidBody> start = time_step.bodies();
        step(time_step, 1);
        for (std::size_t b = 0; b < start.size(); ++b)
            lost += options.step * start[b].mass * time_step.bodies()[b].velocity.cross(start[b].velocity);
    }
    const std::vector<RigidBody>& bodies = time_step.bodies();
    const auto after = total(bodies);
    EXPECT_LT((after - before).head<3>().norm(), 1e-8 * before.head<3>().norm());
    EXPECT_LT((after - before).tail<3>().norm(), 1e-3 * before.tail<3>().norm() + lost.norm());
    EXPECT_LT((bodies[0].velocity - Vector3d(2, 0, 0)).norm(), 3);
    EXPECT_GT(bodies[1].velocity.norm(), 0.5) << "it was hit";
    EXPECT_LT(bodies[2].velocity.norm(), 2.5) << "it hit";
    EXPECT_GT((bodies[0].centre - bodies[1].centre).norm(), 0.0399);
}

// A ball on a slope with friction rolls; its acceleration is 5/7 of the acceleration without friction.
TEST(BodyContact, ABallRollsDownASlope) {
    const double slope = 0.3, seconds = 0.3, gravity = 9.81;
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    const Vector3d normal(std::sin(slope), 0, std::cos(slope)),
        downhill(std::cos(slope), 0, -std::sin(slope));
    for (const double friction : {0.0, 0.6}) {
        StepperOptions options;
        options.step = 1e-3;
        options.contact.obstacles = {obstacle(PlaneShape(Vector3d::Zero(), normal), 3e10, friction)};
        options.contact.bodies = {ball(0.02 * normal, Vector3d::Zero())};
        options.contact.bodies[0].friction = friction;
        ImplicitStepper time_step(shell, options);
        step(time_step, static_cast<int>(seconds / options.step + 0.5));
        const double way = 0.5 * gravity * std::sin(slope) * seconds * seconds * (friction > 0 ? 5.0 / 7 : 1);
        const RigidBody& moved = time_step.bodies()[0];
        EXPECT_NEAR((moved.centre - 0.02 * normal).dot(downhill), way, 0.02 * way) << friction;
        EXPECT_NEAR(moved.spin().y() * 0.02, friction > 0 ? moved.velocity.dot(downhill) : 0,
                    0.03 * moved.velocity.norm());
    }
}

// With Coulomb friction, a box that slides at the speed v must stop after the distance v^2 / (2 mu g).
TEST(BodyContact, FrictionStopsABox) {
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 1e-3;
    options.tolerance = 1e-13;
    options.contact.obstacles = {floor(3e10, 0.8)};
    options.contact.bodies = {rigid_box(Vector3d(0.1, 0.1, 0.02), 1000)};
    options.contact.bodies[0].friction = 0.2;
    options.contact.bodies[0].centre = Vector3d(0, 0, 0.01);
    options.contact.bodies[0].velocity = Vector3d(1, 0, 0);
    ImplicitStepper time_step(shell, options);
    step(time_step, 500);
    const RigidBody& moved = time_step.bodies()[0];
    EXPECT_NEAR(moved.centre.x(), 1 / (2 * 0.4 * 9.81), 0.03 / (2 * 0.4 * 9.81))
        << "the mean of 0.8 and 0.2 is 0.4";
    EXPECT_LT(moved.velocity.norm(), 2e-3);
}

// A box on a slope that is flat enough for friction to hold it must not creep.
TEST(BodyContact, FrictionHoldsABoxOnASlope) {
    const Eigen::AngleAxisd tilt(10 * std::numbers::pi / 180, Vector3d::UnitY());
    Shell shell = lone_vertex(Vector3d(5, 5, 5));
    StepperOptions options;
    options.step = 2e-3;
    options.tolerance = 1e-13;
    options.contact.obstacles = {obstacle(PlaneShape(Vector3d::Zero(), tilt * Vector3d::UnitZ()), 3e10, 0.5)};
    RigidBody box = rigid_box(Vector3d(0.1, 0.1, 0.02), 1000);
    box.friction = 0.5;
    box.rotation = tilt.toRotationMatrix();
    box.centre = tilt * Vector3d(0, 0, 0.01);
    options.contact.bodies = {box};
    ImplicitStepper time_step(shell, options);
    step(time_step, 250);
    const Vector3d before = time_step.bodies()[0].centre;
    step(time_step, 500);
    EXPECT_LT((time_step.bodies()[0].centre - before).norm(), 1e-6 * 0.1);
}

}  // namespace
}  // namespace sherd::test
