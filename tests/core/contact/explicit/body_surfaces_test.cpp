// SPDX-License-Identifier: GPL-3.0-or-later
// In explicit steps edges of bodies must collide with edges of bodies and obstacles, with forces that keep
// momentum and energy, also when implicit steps follow; an overlap that the springs do not stop must be an
// error.
#include <gtest/gtest.h>

#include "core/time/stepper.h"
#include "tests/support/contact/free_boxes.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd::test {
namespace {

/// Bodies, and a plate that is far away.
struct World {
    World() {
        shell.position.row(0).array() += 5;
        shell.velocity.setZero();
        options.scheme = Scheme::explicit_differences;
        options.step = 1e-5;
        options.gravity.setZero();
        options.tolerance = 1e-12;
    }
    void begin() { stepper = make_stepper(shell, options); }
    void advance(double duration) { ASSERT_TRUE(advanced(duration)); }
    /// Advances by `duration` s, or until a step fails. Returns success, or the result of the step that
    /// failed.
    StepResult advanced(double duration) {
        const double length = stepper->scheme() == Scheme::explicit_differences ? options.step : 5e-4;
        for (int i = 0; i < std::lround(duration / length); ++i) {
            StepResult result = stepper->begin(length);
            if (result) result = stepper->solve(200);
            if (!result) return result;
            stepper->finish();
        }
        return {};
    }
    const RigidBody& body(std::size_t number) const { return stepper->bodies()[number]; }

    Shell shell = stacked_plates(1, 2, 0, glass);
    StepperOptions options;
    std::unique_ptr<Stepper> stepper;
};

/// Two boxes that fly towards each other, edge to edge and askew.
std::vector<RigidBody> meeting(double friction) {
    RigidBody one = solid_body(Vector3d(0.1, 0.02, 0.02), Vector3d(0, 0, 0));
    RigidBody other = solid_body(Vector3d(0.02, 0.1, 0.02), Vector3d(0.01, 0.015, 0.0287));
    one.rotation = turn_about(Vector3d::UnitX());
    other.rotation = turn_about(Vector3d::UnitY());
    other.velocity = Vector3d(0.3, 0.2, -2);
    one.friction = other.friction = friction;
    return {one, other};
}

TEST(BodySurfaces, EdgesOfBoxesBounceAndKeepMomentumAndEnergy) {
    for (const double friction : {0.0, 0.3}) {
        World world;
        world.options.step = 2e-6;
        world.options.contact.bodies = meeting(friction);
        const Vector6d before = momenta(world.options.contact.bodies);
        const double energy = kinetic(world.options.contact.bodies);
        world.begin();
        world.advance(1e-3);
        const Vector6d after = momenta(world.stepper->bodies());
        const EnergyBalance& balance = world.stepper->balance();
        EXPECT_GT(world.body(0).velocity.norm(), 0.5) << "it was hit";
        EXPECT_GT(world.body(1).velocity.z(), world.body(0).velocity.z()) << "they part";
        EXPECT_LT((after - before).head<3>().norm(), 1e-12 * before.head<3>().norm());
        EXPECT_LT((after - before).tail<3>().norm(), 1e-8 * before.tail<3>().norm());
        EXPECT_LT(std::abs(balance.unexplained), 1e-10 * energy);
        EXPECT_LT(std::abs(balance.lost_to_scheme), 2e-3 * energy);
        EXPECT_NEAR(kinetic(world.stepper->bodies()), energy - balance.lost_to_friction, 2e-3 * energy);
        EXPECT_EQ(balance.lost_to_friction > 1e-3 * energy, friction > 0);
    }
}

// Two edges of a box lie across two edges of obstacles, far from any corner: with contact at corners alone
// the box would fall through.
TEST(BodySurfaces, EdgesOfObstaclesCarryABox) {
    World world;
    world.options.gravity = Vector3d(0, 0, -9.81);
    world.options.contact.obstacles = {roof(-0.03), roof(0.03)};
    world.options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.01), Vector3d(0, 0, 0.0055))};
    world.begin();
    world.advance(0.03);
    EXPECT_GT(world.body(0).centre.z(), 0.0048) << "it would have fallen by 4 mm";
    EXPECT_LT(world.body(0).centre.z(), 0.0056);
    EXPECT_NEAR(world.body(0).centre.y(), 0, 1e-9);
    const double energy = world.body(0).mass * 9.81 * 0.0055;
    EXPECT_LT(std::abs(world.stepper->balance().unexplained), 1e-10 * energy);
    EXPECT_LT(std::abs(world.stepper->balance().lost_to_scheme), 0.02 * energy);
}

// With a wrong force of a moving obstacle's edges, the box would fly off at a wrong speed, or the obstacle's
// work would be missing in the balance.
TEST(BodySurfaces, AnObstacleThatComesUpThrowsABox) {
    World world;
    Obstacle one = roof(-0.03), other = roof(0.03);
    one.motion.keys = {MotionKey{}, MotionKey{.time = 0.02, .translation = Vector3d(0, 0, 0.02)}};
    other.motion.keys = one.motion.keys;
    world.options.contact.obstacles = {one, other};
    world.options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.01), Vector3d(0, 0, 0.0055))};
    world.begin();
    world.advance(3e-3);
    const RigidBody& box = world.body(0);
    const EnergyBalance& balance = world.stepper->balance();
    EXPECT_GT(box.velocity.z(), 0.9) << "nearly twice the obstacle's velocity then";
    EXPECT_NEAR(balance.work_of_obstacles, box.kinetic_energy(), 1e-2 * box.kinetic_energy());
    EXPECT_LT(std::abs(balance.unexplained), 1e-10 * box.kinetic_energy());
    EXPECT_LT(std::abs(balance.lost_to_scheme), 1e-2 * box.kinetic_energy());
}

// A box rests on edges in implicit steps; it must stay there when explicit steps follow, and implicit ones
// again.
TEST(BodySurfaces, SchemesGoOnWithWhatRestsOnEdges) {
    World world;
    world.options.scheme = Scheme::implicit_euler;
    world.options.gravity = Vector3d(0, 0, -9.81);
    world.options.contact.obstacles = {roof(-0.03), roof(0.03)};
    world.options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.01), Vector3d(0, 0, 0.0052))};
    world.begin();
    world.advance(0.1);
    const double height = world.body(0).centre.z(), weight = world.body(0).mass * 9.81;
    EXPECT_NEAR(height, 0.005, 1e-4);
    const double lost = world.stepper->balance().lost_to_scheme;
    for (const Scheme scheme :
         {Scheme::explicit_differences, Scheme::implicit_euler, Scheme::explicit_differences}) {
        world.stepper = with_scheme(std::move(world.stepper), scheme);
        world.advance(5e-3);
        EXPECT_NEAR(world.body(0).centre.z(), height, 1e-5);
    }
    const EnergyBalance& balance = world.stepper->balance();
    EXPECT_LT(std::abs(balance.unexplained), 1e-9 * weight * 0.005);
    EXPECT_GT(balance.lost_to_scheme - lost, -2e-3 * weight * 0.005) << "energy from nowhere";
}

// Surfaces that intersect at the start must not collide, in any scheme that follows, until they are apart;
// after that they must collide.
TEST(BodySurfaces, WhatCrossesAtTheStartMeetsOnceItIsApart) {
    World world;
    RigidBody up = solid_body(Vector3d(0.02, 0.1, 0.02), Vector3d(0.003, 0.002, 0.015));
    up.velocity = Vector3d(0, 0, 1);
    world.options.contact.bodies = {solid_body(Vector3d(0.1, 0.02, 0.02), Vector3d::Zero()), up};
    world.begin();
    world.advance(1e-3);
    world.stepper = with_scheme(std::move(world.stepper), Scheme::implicit_euler);
    world.advance(1e-3);
    world.stepper = with_scheme(std::move(world.stepper), Scheme::explicit_differences);
    world.advance(0.01);
    EXPECT_NEAR(world.body(1).centre.z(), 0.027, 1e-6);
    EXPECT_LT(world.body(0).velocity.norm(), 1e-9);
    EXPECT_LT(std::abs(world.stepper->balance().lost_to_scheme), 1e-9);

    RigidBody back = world.body(1);
    back.velocity.z() = -1;
    world.options.contact.bodies[1] = back;
    world.begin();
    world.advance(0.012);
    EXPECT_GT(world.body(1).centre.z() - world.body(0).centre.z(), 0.0199);
    EXPECT_GT(world.body(1).velocity.z(), world.body(0).velocity.z());
}

TEST(BodySurfaces, EdgesThatPassEachOtherEndTheRun) {
    World world;
    RigidBody log = solid_body(Vector3d(0.1, 0.02, 0.02), Vector3d(0, 0, 0.03));
    log.rotation = turn_about(Vector3d::UnitX());
    log.velocity = Vector3d(0, 0, -300);
    world.options.contact.obstacles = {roof(0)};
    world.options.contact.bodies = {log};
    world.begin();
    EXPECT_EQ(world.advanced(1e-3).outcome, Outcome::failed);
}

// A fast box that passes a thin wall in a substep must end the run, although none of its corners is ever
// found in the wall.
TEST(BodySurfaces, ABodyThatPassesInASubstepEndsTheRun) {
    World world;
    RigidBody box = solid_body(Vector3d(0.005, 0.005, 0.005), Vector3d(-0.03, 0.0003, 0));
    box.velocity = Vector3d(3000, 0, 0);
    world.options.contact.obstacles = {solid_box(Vector3d::Zero(), Vector3d(5e-7, 0.1, 0.1))};
    world.options.contact.bodies = {box};
    world.begin();
    EXPECT_EQ(world.advanced(1e-4).outcome, Outcome::failed);
}

// A corner that is pressed in deeper than the springs of edges allow is held by its own spring, which must
// return all the energy.
TEST(BodySurfaces, ACornerThatSinksDeepIsThrownBack) {
    World world;
    world.options.step = 2e-6;
    RigidBody box = solid_body(Vector3d(0.02, 0.02, 0.02), Vector3d(0.003, 0.002, 0.0175));
    box.rotation = test::onto_a_corner();
    box.velocity = Vector3d(0, 0, -60);
    box.friction = 0;
    world.options.contact.obstacles = {solid_box(Vector3d(0, 0, -0.05), Vector3d(0.1, 0.1, 0.05))};
    world.options.contact.bodies = {box};
    world.begin();
    world.advance(4e-4);
    EXPECT_GT(world.body(0).velocity.z(), 40);
    EXPECT_LT(std::abs(world.stepper->balance().unexplained), 1e-10 * box.kinetic_energy());
    EXPECT_LT(std::abs(world.stepper->balance().lost_to_scheme), 0.01 * box.kinetic_energy());
}

}  // namespace
}  // namespace sherd::test
