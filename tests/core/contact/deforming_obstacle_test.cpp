// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles with prescribed points, which have no inside and no springs: all contact forces on a sheet come
// from the obstacles' triangles.
#include <gtest/gtest.h>

#include <numbers>

#include "core/contact/sheets/sheet_contact.h"
#include "core/time/implicit_stepper.h"
#include "tests/support/contact/collider_gap.h"
#include "tests/support/contact/contact_pairs.h"
#include "tests/support/contact/deforming_strip.h"
#include "tests/support/contact/friction_of_motion.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd::test {
namespace {

/// Strip along x that closes like a book about the y axis: each half turns from flat by 90 degrees in 1 s.
Obstacle closing_book(double length, double width, int count) {
    std::vector<Positions> samples;
    for (int s = 0; s <= 40; ++s) {
        Positions sample = strip_points(length, width, count);
        const double angle = std::numbers::pi / 2 * s / 40;
        for (auto point : sample.colwise()) {
            const double x = point.x();
            point.x() = x * std::cos(angle);
            point.z() = std::abs(x) * std::sin(angle);
        }
        samples.push_back(sample);
    }
    return deforming(samples, strip_triangles(count), 1.0 / 40);
}

StepperOptions against(const Obstacle& obstacle, double step, Scheme scheme = Scheme::implicit_euler) {
    StepperOptions options;
    options.scheme = scheme;
    options.step = step;
    options.gravity.setZero();
    options.contact.obstacles = {obstacle};
    options.tolerance = 1e-9;
    return options;
}

/// Advances by `count` steps; fails unless each step can be solved and leaves a gap.
void advance(Shell& shell, Stepper& stepper, const StepperOptions& options, int count) {
    for (int i = 1; i <= count; ++i) {
        ASSERT_TRUE(stepper.begin()) << "step " << i;
        ASSERT_TRUE(stepper.solve(200)) << "step " << i;
        stepper.finish();
        ASSERT_GT(gap(shell, options.contact.obstacles[0], i * options.step), 0) << "step " << i;
    }
}

// Coplanar triangles of a deforming obstacle may bend later; without the edge between them a sheet would
// pass there.
TEST(DeformingObstacle, KeepsEdgesOfCoplanarTriangles) {
    const Positions points = strip_points(1, 1, 4);
    EXPECT_EQ(collider_surface(points, strip_triangles(4), true).edges.size(), 30u);
    EXPECT_EQ(collider_surface(points, strip_triangles(4)).edges.size(), 12u) << "the rim";
}

// A deforming obstacle must push from a gap of half the sheet's thickness on, where the springs of a rigid
// obstacle begin. (The surface of a rigid obstacle pushes from a quarter of the thickness on.)
TEST(DeformingObstacle, PushesFromHalfTheThicknessOn) {
    for (const double height : {0.49, 0.51}) {
        Shell shell = stacked_plates(1, 2, 0, firm_rubber);
        shell.position.row(2).array() += height * firm_rubber.thickness;
        SheetContact contact(shell, {closing_book(0.3, 0.3, 4)}, false);
        EXPECT_EQ(contact.active_pairs(shell.position).empty(), height > 0.5);
    }
}

// Wrong derivatives of the contact energy would push the sheet wrongly, also while the obstacle's points move
// apart.
TEST(DeformingObstacle, ForceAndStiffnessAreDerivativesOfTheValue) {
    Shell shell = stacked_plates(1, 2, 0, firm_rubber);
    const Matrix3d tilt = Eigen::AngleAxisd(0.01, Vector3d(1, 0.6, 0.2).normalized()).toRotationMatrix();
    shell.position = (tilt * shell.position).eval();
    shell.position.row(2).array() += 0.5 * firm_rubber.thickness;
    const Obstacle moving = belt(0.02, 2, 0.4);
    SheetContact contact(shell, {moving}, false);
    const StepContext moved = step_of(shell, 0, 1e-3);
    contact.begin(moved);
    ASSERT_GT(contact.active_pairs(shell.position).size(), 0u);
    expect_derivatives(contact, shell.position, 1e-9, 1e-4);
    expect_friction_along_x(shell, contact, moved);
}

// An obstacle whose points all move like those of a rigid wall must act like the wall, although the springs
// of the wall are softer at first: a plate that is taken along must fly off equally fast. The wall also
// turns while it moves.
TEST(DeformingObstacle, ThatMovesRigidlyDoesWhatARigidOneDoes) {
    Vector3d velocity[2];
    for (const bool deforms : {false, true}) {
        Shell shell = stacked_plates(1, 4, 0, firm_rubber);
        shell.position.row(2).array() += 0.003;
        Obstacle wall = solid_box(Vector3d::Zero(), Vector3d(0.2, 0.2, 5e-5));
        wall.motion.smooth = false;
        wall.motion.keys = {{0, Vector3d::Zero(), Vector3d::UnitZ(), 0},
                            {1, Vector3d(0, 0, 20), Vector3d::UnitX(), 0.3}};
        if (deforms) {
            std::vector<Positions> samples;
            for (int i = 0; i <= 20; ++i) samples.push_back(wall.points_at(1e-3 * i));
            wall = deforming(samples, wall.surface->triangles, 1e-3);
        }
        const StepperOptions options = against(wall, 1e-3);
        ImplicitStepper stepper(shell, options);
        advance(shell, stepper, options, 20);
        velocity[deforms] = shell.velocity.rowwise().mean();
    }
    EXPECT_GT(velocity[0].z(), 15);
    EXPECT_LT((velocity[1] - velocity[0]).norm(), 0.03 * velocity[0].norm());
}

// Two halves of a book close on a plate that lies across the fold: they may bend it or push it out, but not
// cut it.
TEST(DeformingObstacle, ThatClosesOnAPlateDoesNotPassThroughIt) {
    for (const Scheme scheme : {Scheme::implicit_euler, Scheme::explicit_differences}) {
        Shell shell = stacked_plates(1, 4, 0, firm_rubber);
        shell.position.row(2).array() += 0.01;
        const StepperOptions options = against(closing_book(0.3, 0.2, 6), 2e-3, scheme);
        const std::unique_ptr<Stepper> stepper = make_stepper(shell, options);
        advance(shell, *stepper, options, 150);
        const double height = shell.position.row(2).mean();
        EXPECT_GT(height, 0.02) << "it was pushed up";
        // The plate's energy must come from the work of the obstacle.
        const EnergyBalance& balance = stepper->balance();
        const double kinetic = 0.5 * shell.mass.sum() * shell.velocity.rowwise().mean().squaredNorm();
        EXPECT_GT(balance.work_of_obstacles, kinetic);
        EXPECT_LT(std::abs(balance.lost_to_scheme), 0.3 * balance.work_of_obstacles);
        EXPECT_LT(std::abs(balance.unexplained), 1e-6 * balance.work_of_obstacles);
    }
}

// A plate on a belt is taken along, and its energy must come from friction.
TEST(DeformingObstacle, CarriesWhatLiesOnItByFriction) {
    constexpr double speed = 0.2, coefficient = 0.5, fall = 9.81;
    for (const Scheme scheme : {Scheme::implicit_euler, Scheme::explicit_differences}) {
        Shell shell = stacked_plates(1, 4, 0, firm_rubber);
        shell.position.row(2).array() += 0.4999 * firm_rubber.thickness;
        StepperOptions options = against(belt(speed, 1, coefficient), 1e-3, scheme);
        options.gravity = Vector3d(0, 0, -fall);
        const std::unique_ptr<Stepper> stepper = make_stepper(shell, options);
        const auto mean = [&] { return shell.velocity.row(0).mean(); };
        advance(shell, *stepper, options, 20);
        EXPECT_NEAR(mean(), coefficient * fall * 0.02, 0.15 * coefficient * fall * 0.02) << "it slides";
        advance(shell, *stepper, options, 60);
        EXPECT_NEAR(mean(), speed, 0.02 * speed);
        const double kinetic = 0.5 * shell.mass.sum() * speed * speed;
        const EnergyBalance& balance = stepper->balance();
        EXPECT_NEAR(balance.work_of_obstacles, 2 * kinetic, 0.1 * kinetic);
        EXPECT_NEAR(balance.lost_to_friction, kinetic, 0.1 * kinetic);
        EXPECT_LT(std::abs(balance.unexplained), 1e-6 * kinetic);
    }
}

// A belt that is stretched below a plate at rest must pull the plate's halves apart by friction, and the
// plate must stay.
TEST(DeformingObstacle, ThatIsStretchedPullsBothWays) {
    Shell shell = stacked_plates(1, 4, 0, firm_rubber);
    shell.position.row(2).array() += 0.499 * firm_rubber.thickness;
    StepperOptions options = against(belt(0, 3, 0.5), 1e-3);
    options.gravity = Vector3d(0, 0, -9.81);
    ImplicitStepper stepper(shell, options);
    advance(shell, stepper, options, 40);
    EXPECT_LT(std::abs(shell.velocity.row(0).mean()), 1e-3);
    EXPECT_GT(stepper.balance().lost_to_friction, 0);
    const double width = shell.position.row(0).maxCoeff() - shell.position.row(0).minCoeff();
    EXPECT_GT(width, shell.rest.row(0).maxCoeff() - shell.rest.row(0).minCoeff()) << "it was stretched";
}

// A pinned vertex that touches the obstacle at the start is held by it, and must not collide with it.
TEST(DeformingObstacle, DoesNotMeetWhatIsPinnedOnIt) {
    Shell shell = stacked_plates(1, 4, 0, firm_rubber);
    shell.fixed[0] = 1;
    const auto around = [&](double height) {
        Shell placed = shell;
        placed.position.row(2).array() += height * firm_rubber.thickness;
        return contact_colliders(placed, {closing_book(0.3, 0.3, 4)})[0].around;
    };
    EXPECT_EQ(around(0.4), std::vector<Index>{0});
    EXPECT_TRUE(around(0.6).empty());
}

}  // namespace
}  // namespace sherd::test
