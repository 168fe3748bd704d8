// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/penalty/obstacle_contact.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "core/time/implicit_stepper.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/random_shapes.h"
#include "tests/support/shell/steps.h"

namespace sherd::test {
namespace {

void advance(ImplicitStepper& time_step, double step, double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / step)); ++i) {
        time_step.begin(step);
        time_step.solve(20);
        time_step.finish();
    }
}

/// Advances `seconds` in steps of `step`.
void simulate(Shell& shell, StepperOptions options, double step, double seconds) {
    options.step = step;
    ImplicitStepper time_step(shell, options);
    advance(time_step, step, seconds);
}

/// Plane whose distance grows by 0.8 m for each metre: too slowly, as interpolated distances do at the edges
/// of the sampled range.
struct SampledShape : Shape {
    SurfaceDistance distance(const Vector3d& point) const override {
        const Vector3d gradient = 0.8 * Vector3d(0.1, 0.2, 1).normalized();
        return {gradient.dot(point), gradient, Matrix3d::Zero()};
    }
    Eigen::AlignedBox3d bounds() const override {
        return {Vector3d::Constant(-std::numeric_limits<double>::infinity()),
                Vector3d::Constant(std::numeric_limits<double>::infinity())};
    }
};

// Wrong derivatives would push sheets wrongly or keep the solver from converging: on obstacles of all
// shapes, at rest and moving, with friction that sticks and slides.
TEST(ObstacleContact, ForceAndStiffnessAreDerivativesOfTheValue) {
    Random random(1);
    Motion turning;
    turning.keys = {{0, Vector3d::Zero(), Vector3d::UnitZ(), 0},
                    {1, Vector3d(1e-3, 2e-3, 0), Vector3d::UnitX(), 2e-3}};
    const Vector3d tilted = Vector3d(0.1, 0.2, 1).normalized();
    std::vector<Obstacle> obstacles{
        obstacle(PlaneShape(Vector3d::Zero(), tilted), 1e7, 0.4),
        obstacle(SphereShape(Vector3d(0, 0, -0.02), 0.02), 1e7, 0.4),
        obstacle(BoxShape(Vector3d(-1, 0, -1), Vector3d(1, 1, 1)), 1e7, 0.4),
        obstacle(CylinderShape(Vector3d(0, 0, -0.5), Vector3d::UnitX(), 0.5, 1), 1e7, 0.4),
        obstacle(SampledShape(), 1e7, 0.4)};
    for (Obstacle& obstacle : obstacles) {
        const Shell shell = lone_vertex(Vector3d(0.0001, 0, 0.0049));
        for (const bool moves : {false, true}) {
            if (moves) obstacle.motion = turning;
            const ObstacleContact contact = test::begun(ObstacleContact(shell, obstacle), shell, 0.5, 1e-3);
            Touch touch;
            contact.add_touch(shell.position, touch);
            EXPECT_EQ(touch.vertices.size(), 1u);
            for (int i = 0; i < 50; ++i) {
                const double way = i % 2 ? 3e-5 : 2e-6;  // beyond and within friction's smoothing
                const Vector3d moved = Vector3d(shell.position.col(0)) + random.matrix<Vector3d>(way);
                expect_derivatives(contact, Positions(moved), 1e-9, 1e-4);
            }
        }
    }
}

// A resting vertex sinks in by its weight over the stiffness of both materials in series over its footprint.
TEST(ObstacleContact, RestingWeightSinksInAsTheTwoMaterialsSay) {
    Shell shell = lone_vertex(Vector3d(0, 0, 0.005));
    StepperOptions options;
    options.contact.obstacles = {floor(1e7)};
    options.tolerance = 1e-14;
    simulate(shell, options, 1e-3, 4);
    const double stiffness = 1e-4 / 0.01 / (2 / 1e7);
    EXPECT_NEAR(0.005 - shell.position(2, 0), 0.1 * 9.81 / stiffness, 1e-9);
}

// A vertex falls, is in contact for about half a vibration of the spring, and rises as high again; with long
// steps it would stay down.
TEST(ObstacleContact, BouncesAsTheSpringSays) {
    const double height = 0.01, gravity = 9.81, mass = 0.1, stiffness = 5e4, length = 2e-6;
    Shell shell = lone_vertex(Vector3d(0, 0, 0.005 + height));
    StepperOptions options;
    options.step = length;
    options.contact.obstacles = {floor(1e7)};
    options.tolerance = 1e-14;
    ImplicitStepper time_step(shell, options);
    const double fall = std::sqrt(2 * height / gravity), swing = std::sqrt(mass / stiffness);
    const double sinking = mass * gravity / stiffness,
                 amplitude = std::hypot(sinking, gravity * fall * swing);
    const double contact = 2 * swing * (std::numbers::pi - std::acos(sinking / amplitude));
    const auto advance_to = [&](double time, int& done, auto&& look) {
        for (; done < std::lround(time / length); ++done) {
            time_step.begin();
            time_step.solve(20);
            time_step.finish();
            look(shell.position(2, 0) - 0.005);
        }
    };
    int done = 0;
    double lowest = 0;
    advance_to(fall, done, [](double) {});
    EXPECT_NEAR(shell.position(2, 0), 0.005, 1e-3 * height);
    EXPECT_NEAR(shell.velocity(2, 0), -gravity * fall, 1e-3 * gravity * fall);
    advance_to(fall + contact, done, [&](double at) { lowest = std::min(lowest, at); });
    EXPECT_NEAR(-lowest, sinking + amplitude, 5e-3 * amplitude);
    EXPECT_NEAR(shell.position(2, 0), 0.005, 5e-3 * height) << "just leaving";
    advance_to(2 * fall + contact, done, [](double) {});
    EXPECT_NEAR(shell.position(2, 0), 0.005 + height, 0.01 * height) << "as high as it was";
}

// Coulomb friction slows a vertex down by mu g, so that it stops after v^2 / (2 mu g).
TEST(ObstacleContact, FrictionStopsASlidingVertexAfterTheCoulombDistance) {
    Shell shell = lone_vertex(Vector3d(0, 0, 0.005 - 0.1 * 9.81 / 5e4));
    shell.velocity(0, 0) = 1;
    StepperOptions options;
    options.contact.obstacles = {floor(1e7, 0.5)};
    options.tolerance = 1e-13;
    simulate(shell, options, 1e-4, 0.4);
    const double distance = 1 / (2 * 0.5 * 9.81);
    EXPECT_NEAR(shell.position(0, 0), distance, 0.01 * distance);
    EXPECT_LT(shell.velocity.col(0).norm(), 1e-3);
}

// On a slope of 30 degrees a vertex must accelerate by g (sin a - mu cos a), on a plane and on a box alike.
TEST(ObstacleContact, SlidesDownASlopeAsGalileoSays) {
    const double slope = std::numbers::pi / 6, friction = 0.3, gravity = 9.81, seconds = 0.2;
    Obstacle tilted_box = obstacle(BoxShape(Vector3d(0, 0, -1), Vector3d(3, 1, 1)), 1e7, friction);
    tilted_box.motion.place = Eigen::AngleAxisd(slope, Vector3d::UnitY());
    const Vector3d normal(std::sin(slope), 0, std::cos(slope)),
        downhill(std::cos(slope), 0, -std::sin(slope));
    const double sinking = 0.1 * gravity * std::cos(slope) / 5e4;
    for (const Obstacle& ramp : {obstacle(PlaneShape(Vector3d::Zero(), normal), 1e7, friction), tilted_box}) {
        Shell shell = lone_vertex((0.005 - sinking) * normal);
        StepperOptions options;
        options.contact.obstacles = {ramp};
        options.tolerance = 1e-13;
        simulate(shell, options, 1e-4, seconds);
        const double way = 0.5 * gravity * (std::sin(slope) - friction * std::cos(slope)) * seconds * seconds;
        EXPECT_NEAR(shell.position.col(0).dot(downhill), way, 0.01 * way);
        EXPECT_NEAR(shell.position.col(0).dot(normal), 0.005 - sinking, 1e-6);
    }
}

// A tray that starts gently takes its load along; a tray that starts too fast slips away below its load.
TEST(ObstacleContact, FrictionCarriesWhatLiesOnAMovingBox) {
    const double gravity = 9.81, friction = 0.4, seconds = 0.5;
    const auto way_on_tray = [&](double acceleration) {
        Obstacle tray = obstacle(BoxShape(Vector3d(0, 0, -0.1), Vector3d(1, 1, 0.1)), 1e7, friction);
        // In smooth motion by D (3 s^2 - 2 s^3), s = t / T, the acceleration falls from 6 D / T^2 at the
        // start to zero at half time.
        const double way = acceleration * seconds * seconds / 6;
        tray.motion.keys = {{0, Vector3d::Zero(), Vector3d::UnitZ(), 0},
                            {seconds, Vector3d(0, way, 0), Vector3d::UnitZ(), 0}};
        Shell shell = lone_vertex(Vector3d(0, 0, 0.005 - 0.1 * gravity / 5e4));
        StepperOptions options;
        options.contact.obstacles = {tray};
        options.tolerance = 1e-13;
        simulate(shell, options, 1e-3, 0.5 * seconds);
        return shell.position(1, 0) / (0.5 * way);
    };
    EXPECT_NEAR(way_on_tray(0.9 * friction * gravity), 1, 0.02) << "carried";
    // The load slides all the time and accelerates by mu g: until half time it moves by mu g T^2 / 8, and
    // the tray by half of its displacement.
    EXPECT_NEAR(way_on_tray(10 * friction * gravity), 0.5 * 0.25 / (0.5 * 10.0 / 6), 0.02) << "left behind";
}

// A soft plate on the top of a ball must hang over it and stay.
TEST(ObstacleContact, APlateRestsOnTheTopOfASphere) {
    Material material;
    material.density = 1000, material.thickness = 0.002, material.young = 1e6;
    Shell shell = stacked_plates(1, 8, 0, material);
    StepperOptions options;
    options.contact.obstacles = {obstacle(SphereShape(Vector3d(0, 0, -0.101), 0.1), 1e9, 0.5)};
    options.shell.damping.mass = 20;
    options.step = 2e-3;
    ImplicitStepper time_step(shell, options);
    advance(time_step, options.step, 1);
    const Positions before = shell.position;
    const double height = (before * shell.mass).z() / shell.mass.sum();
    EXPECT_LT(height, -0.002) << "its corners hang";
    advance(time_step, options.step, 1);
    EXPECT_LT((shell.position - before).colwise().norm().maxCoeff(), 1e-4 * 0.1);
}

}  // namespace
}  // namespace sherd::test
