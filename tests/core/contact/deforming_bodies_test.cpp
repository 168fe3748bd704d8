// SPDX-License-Identifier: GPL-3.0-or-later
// Free bodies on deforming obstacles, which have no inside and no springs: all contact forces on a body come
// from the obstacles' triangles, in implicit and explicit steps.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/time/stepper.h"
#include "tests/support/contact/deforming_strip.h"
#include "tests/support/contact/free_boxes.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd::test {
namespace {

/// Plate 0.2 m wide that bulges in `duration` s: its middle rises by `height` m, and its rims across x by
/// `rim` times as much.
Obstacle bulge(double height, double duration, double rim = 1) {
    std::vector<Positions> samples;
    for (int s = 0; s <= 40; ++s) {
        Positions sample = strip_points(0.2, 0.2, 8);
        for (auto point : sample.colwise()) {
            const double out = std::abs(point.x()) / 0.1;
            point.z() = height * s / 40 * (1 + (rim - 1) * out * out);
        }
        samples.push_back(sample);
    }
    return deforming(samples, strip_triangles(8), duration / 40);
}

/// Bodies and an obstacle, with a plate that is held far away from them.
struct Scene {
    Scene(const Obstacle& obstacle, const std::vector<RigidBody>& bodies, Scheme scheme) {
        shell.position.row(0).array() += 5;
        shell.velocity.setZero();
        std::ranges::fill(shell.fixed, 1);
        options.scheme = scheme;
        options.step = scheme == Scheme::explicit_differences ? 2e-5 : 1e-3;
        options.tolerance = 1e-12;
        options.contact.obstacles = {obstacle};
        options.contact.bodies = bodies;
        stepper = make_stepper(shell, options);
    }
    void advance(double duration) { ASSERT_TRUE(advanced(duration)); }
    /// Advances by `duration` s, in steps that are halved where they cannot be solved. Returns success, or
    /// the result of the first step that failed for good.
    StepResult advanced(double duration) {
        double length = options.step;
        for (double time = 0; time < duration * (1 - 1e-9);) {
            StepResult result = stepper->begin(length);
            if (result) result = stepper->solve(200);
            if (result) {
                stepper->finish();
                time += length;
                length = std::min(2 * length, options.step);
            } else if (result.outcome == Outcome::failed || (length /= 2) <= options.step / 4096) {
                return result;
            }
        }
        return {};
    }
    const RigidBody& body(std::size_t number) const { return stepper->bodies()[number]; }

    Shell shell = stacked_plates(1, 2, 0, glass);
    StepperOptions options;
    std::unique_ptr<Stepper> stepper;
};

RigidBody round_body(double radius, const Vector3d& centre) {
    RigidBody ball = rigid_sphere(radius, 2000);
    ball.surface = sphere_surface(radius, 3);
    ball.centre = centre;
    ball.friction = 0.3;
    return ball;
}

class DeformingBodies : public testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Deforming, DeformingBodies,
                         testing::Values(Scheme::implicit_euler, Scheme::bdf2, Scheme::explicit_differences));

// The plate must carry the bodies up, and its work on them must be in the energy balance.
TEST_P(DeformingBodies, APlateThatRisesCarriesABoxAndABall) {
    const double height = 0.02, duration = 0.06;
    Obstacle plate = bulge(height, duration);
    plate.friction = 0.3;
    Scene scene(plate,
                {solid_body(Vector3d(0.04, 0.03, 0.02), Vector3d(-0.04, 0, 0.01)),
                 round_body(0.01, Vector3d(0.04, 0.003, 0.01))},
                GetParam());
    scene.advance(duration);
    double gained = kinetic(scene.stepper->bodies());
    for (const std::size_t b : {0, 1}) {
        EXPECT_GT(scene.body(b).centre.z(), height + 0.0098) << b;
        gained += scene.body(b).mass * 9.81 * (scene.body(b).centre.z() - 0.01);
    }
    EXPECT_NEAR(scene.body(0).centre.x(), -0.04, 1e-3);
    const EnergyBalance& balance = scene.stepper->balance();
    EXPECT_LT(std::abs(balance.unexplained), 1e-6 * gained);
    EXPECT_NEAR(
        balance.work_of_obstacles,
        gained + balance.lost_to_friction + balance.lost_to_scheme + scene.stepper->energies().contact,
        1e-5 * gained);
    EXPECT_GT(balance.lost_to_scheme, -0.1 * gained) << "all else is the work of the plate";
    if (GetParam() == Scheme::explicit_differences) {
        EXPECT_LT(std::abs(balance.lost_to_scheme), 0.02 * gained);
    }
}

// Bodies must meet the deformed shape: a box lies across the top of a bulge, where neither a corner of the
// box nor one of the bulge is near.
TEST_P(DeformingBodies, ABoxLiesAcrossABulge) {
    Scene scene(bulge(0.01, 0.05, 0), {solid_body(Vector3d(0.12, 0.02, 0.01), Vector3d(0, 0, 0.006))},
                GetParam());
    scene.advance(0.05);
    EXPECT_GT(scene.body(0).centre.z(), 0.0148) << "above the top, where the surface has an edge";
}

TEST_P(DeformingBodies, ABeltTakesABoxAlong) {
    Obstacle moving = belt(0.5, 1, 0.8);
    Scene scene(moving, {solid_body(Vector3d(0.04, 0.03, 0.02), Vector3d(-0.1, 0, 0.01))}, GetParam());
    const double coefficient = std::sqrt(0.8 * 0.3);
    scene.advance(0.05);
    EXPECT_NEAR(scene.body(0).velocity.x(), coefficient * 9.81 * 0.05, 0.1 * coefficient * 9.81 * 0.05)
        << "it still slides";
    const EnergyBalance& balance = scene.stepper->balance();
    const double kinetic = scene.body(0).kinetic_energy();
    EXPECT_LT(std::abs(balance.unexplained), 1e-6 * kinetic);
    EXPECT_NEAR(balance.work_of_obstacles, kinetic + balance.lost_to_friction + balance.lost_to_scheme,
                0.02 * kinetic);
    EXPECT_GT(balance.lost_to_friction, kinetic) << "it slides farther than it moves";
    EXPECT_GT(balance.lost_to_scheme, -0.1 * kinetic) << "all else is the work of the belt";
}

// No fast body may pass through a deforming obstacle, from either side; an explicit step in which it would
// must fail.
TEST(DeformingBodies, FastOnesDoNotPass) {
    for (const double from : {1.0, -1.0}) {
        RigidBody ball = round_body(0.0025, Vector3d(0.013, 0.008, 0.03 * from));
        ball.velocity = Vector3d(0, 0, -1000 * from);
        Scene scene(bulge(0.001, 0.01), {ball}, Scheme::implicit_euler);
        scene.options.step = 1e-4;
        scene.advance(1e-4);
        EXPECT_GT(from * scene.body(0).centre.z(), 0) << from;
    }
    RigidBody ball = round_body(0.0025, Vector3d(0.013, 0.008, 0.03));
    ball.velocity = Vector3d(0, 0, -1000);
    Scene scene(bulge(0.001, 0.01), {ball}, Scheme::explicit_differences);
    EXPECT_EQ(scene.advanced(1e-4).outcome, Outcome::failed);
}

// A body that starts across a deforming obstacle must fall freely through it.
TEST_P(DeformingBodies, WhatStartsAcrossPasses) {
    Scene scene(bulge(0.0001, 1), {solid_body(Vector3d(0.04, 0.03, 0.02), Vector3d(0, 0, 0.002))},
                GetParam());
    scene.advance(0.02);
    EXPECT_NEAR(scene.body(0).velocity.z(), -9.81 * 0.02, 1e-6);
}

}  // namespace
}  // namespace sherd::test
