// SPDX-License-Identifier: GPL-3.0-or-later
// Explicit steps against theory and conservation laws: with too long a substep, or a force that is missing or
// late, energy would grow, momentum be lost or a frequency be wrong.
#include "core/time/explicit_stepper.h"

#include <gtest/gtest.h>

#include "core/time/frequency_bounds.h"
#include "tests/support/contact/contact_pairs.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/elastic_gradient.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

StepperOptions explicit_steps(double step, bool gravity = false) {
    StepperOptions options;
    options.scheme = Scheme::explicit_differences;
    options.step = step;
    if (!gravity) options.gravity.setZero();
    return options;
}

void advance(Stepper& stepper, int steps) {
    for (int i = 0; i < steps; ++i) {
        ASSERT_TRUE(stepper.begin());
        ASSERT_TRUE(stepper.solve(1));
        stepper.finish();
    }
}

/// Vibration modes of the shell at rest, with fixed vertices left out.
test::Modes modes_at_rest(Stepper& stepper, const Shell& shell, const std::vector<Energy*>& energies) {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Energy* energy : energies) energy->add_pattern(pairs);
    BlockMatrix matrix(static_cast<Index>(shell.mass.size()), pairs, shell.fixed);
    for (const Energy* energy : energies) energy->add_hessian(stepper.position, Curvature::exact, matrix);
    const VectorXd mass = shell.mass.replicate(1, 3).transpose().reshaped();
    return test::modes_of(test::dense(matrix), mass);
}

class ExplicitModes : public ::testing::Test {
  protected:
    void SetUp() override {
        ExplicitStepper stepper(shell, explicit_steps(1e-5));
        const test::Modes solved = modes_at_rest(stepper, shell, forces.elastic());
        squares = solved.squares;
        modes = solved.vectors;
    }

    Shell shell = test::stacked_plates(1, 5, 0, test::glass);
    ShellEnergies forces{shell, {}};
    VectorXd squares;
    Eigen::MatrixXd modes;
};

// A mode of vibration must keep its frequency and its energy.
TEST_F(ExplicitModes, SwingWithTheirFrequencyAndKeepTheirEnergy) {
    const Eigen::Index number = 20;  // a bending mode; the first six are rigid
    const double frequency = std::sqrt(squares[number]), period = 2 * std::numbers::pi / frequency;
    const Positions shape = modes.col(number).reshaped(3, shell.mass.size());
    const double scale = 1e-6 / shape.cwiseAbs().maxCoeff();
    shell.position = shell.rest + scale * shape;
    ExplicitStepper stepper(shell, explicit_steps(period / 50));
    advance(stepper, 500);
    const double energy = 0.5 * squares[number] * scale * scale;
    const PotentialEnergies stored = stepper.energies();
    EXPECT_NEAR(stored.bending + stored.membrane + kinetic_energy(shell), energy, 0.01 * energy);
    const Positions away = (shell.position - shell.rest) / scale;
    const double phase = (away.cwiseProduct(shape).colwise().sum() * shell.mass).value();
    EXPECT_GT(phase, 0.99) << "after ten periods it is where it began";
}

// Damping by stiffness takes the energy of a mode at the rate of the coefficient times the frequency
// squared.
TEST_F(ExplicitModes, DampingTakesTheEnergyThatTheoryTells) {
    const Eigen::Index number = 20;
    const double frequency = std::sqrt(squares[number]), period = 2 * std::numbers::pi / frequency;
    const Positions shape = modes.col(number).reshaped(3, shell.mass.size());
    const double scale = 1e-6 / shape.cwiseAbs().maxCoeff();
    shell.position = shell.rest + scale * shape;
    StepperOptions options = explicit_steps(period / 50);
    const double ratio = 0.01;
    options.shell.damping.stiffness = 2 * ratio / frequency;
    ExplicitStepper stepper(shell, options);
    advance(stepper, 500);
    const double energy = 0.5 * squares[number] * scale * scale;
    const double left = std::exp(-2 * ratio * 2 * std::numbers::pi * 10);
    EXPECT_NEAR(stepper.balance().lost_to_damping, (1 - left) * energy, 0.02 * energy);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-9 * energy);
}

// A plate that flies and vibrates by large angles must keep its energy and both momenta.
TEST(ExplicitStepper, KeepsEnergyAndMomentumInFreeFlight) {
    Shell shell = test::stacked_plates(1, 6, 0, test::rubber);
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v) {
        const Vector3d at = shell.rest.col(v);
        shell.velocity.col(v) =
            Vector3d(1, 2, 3) + Vector3d(40, 10, -20).cross(at) + Vector3d(0, 0, 400 * at.x() * at.y());
    }
    const Vector3d linear = linear_momentum(shell), angular = angular_momentum(shell);
    const double kinetic = kinetic_energy(shell);
    ExplicitStepper stepper(shell, explicit_steps(2e-4));
    advance(stepper, 500);
    EXPECT_LT((linear_momentum(shell) - linear).norm(), 1e-11 * linear.norm());
    EXPECT_LT((angular_momentum(shell) - angular).norm(), 1e-6 * angular.norm());
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 2e-3 * kinetic);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-11 * kinetic);
}

/// A plate of 31 x 31 vertices, three of which lie next to another one, so that the faces between are narrow.
Shell plate_with_few_narrow_faces() {
    const Shell even = test::stacked_plates(1, 30, 0, test::glass);
    Positions rest = even.rest;
    for (const Index v : {200, 460, 700})
        rest.col(v) = rest.col(v + 1) + 0.1 * (rest.col(v) - rest.col(v + 1));
    std::vector<std::array<Index, 3>> triangles;
    for (const TriangleStencil& triangle : even.triangles) triangles.push_back(triangle.vertices);
    return test::small_sheet(rest, triangles, test::glass);
}

// A few narrow faces must not make the substep shorter for all vertices, and a plate with local time steps
// that flies and vibrates must keep its energy and both momenta.
TEST(ExplicitStepper, KeepsEnergyAndMomentumWithLocalSteps) {
    Shell shell = plate_with_few_narrow_faces();
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v) {
        const Vector3d at = shell.rest.col(v);
        shell.velocity.col(v) = Vector3d(1, 2, 3) + Vector3d(40, 10, -20).cross(at) +
                                Vector3d(0, 0, 2 * std::cos(60 * at.x()) * std::cos(90 * at.y()));
    }
    ShellEnergies energies(shell, {});
    FrequencyBounds bounds;
    bounds.find(energies.elastic(), shell, shell.rest);
    const double step = 2e-5, shortest = 1.8 / std::sqrt(bounds.squares().maxCoeff());
    const Vector3d linear = linear_momentum(shell), angular = angular_momentum(shell);
    const double kinetic = kinetic_energy(shell);
    ExplicitStepper stepper(shell, explicit_steps(step));
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(stepper.begin());
        const StepResult made = stepper.solve(1);
        ASSERT_TRUE(made);
        EXPECT_LT(made.iterations, 0.5 * step / shortest);
        stepper.finish();
    }
    EXPECT_LT((linear_momentum(shell) - linear).norm(), 1e-11 * linear.norm());
    EXPECT_LT((angular_momentum(shell) - angular).norm(), 1e-9 * angular.norm());
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 2e-3 * kinetic);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-11 * kinetic);
}

// Vibrations that are faster than substeps would gain energy each time levels or substeps change, as at each
// crack: once the shell has changed, all vertices must have the substep of the fastest.
TEST(ExplicitStepper, EndsLocalStepsWhenTheShellChanges) {
    Shell shell = plate_with_few_narrow_faces();
    ExplicitStepper stepper(shell, explicit_steps(2e-5));
    const auto iterations_of_step = [&] {
        EXPECT_TRUE(stepper.begin());
        const StepResult made = stepper.solve(1);
        EXPECT_TRUE(made);
        stepper.finish();
        return made.iterations;
    };
    const int with_levels = iterations_of_step();
    ASSERT_TRUE(stepper.begin());
    ASSERT_TRUE(stepper.solve(1));
    stepper.topology_changed({});
    stepper.finish();
    EXPECT_GT(iterations_of_step(), 1.9 * with_levels);
}

// Contact that requires shorter substeps ends local steps, too, and a plate with narrow faces that bounces
// off a stiff floor must keep its energy.
TEST(ExplicitStepper, EndsLocalStepsInContactAndKeepsEnergy) {
    Shell shell = plate_with_few_narrow_faces();
    const Eigen::AngleAxisd tilt(0.02, Vector3d::UnitY());
    shell.position = tilt.toRotationMatrix() * shell.rest;
    const double lowest = shell.position.row(2).minCoeff();
    shell.position.row(2).array() += 1e-4 + 0.5 * test::glass.thickness - lowest;
    shell.velocity.row(2).setConstant(-2);
    StepperOptions options = explicit_steps(2e-5);
    options.contact.obstacles = {test::floor(1e10)};
    ExplicitStepper stepper(shell, options);
    const double kinetic = kinetic_energy(shell);
    advance(stepper, 1);
    const double with_levels = stepper.substep();
    advance(stepper, 39);
    EXPECT_LT(stepper.substep(), with_levels / 1.9);
    EXPECT_GT((shell.velocity * shell.mass).z(), -1.9 * shell.mass.sum()) << "it has not met the floor";
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 2e-3 * kinetic);
}

// Contact with a stiff floor concerns the vertices near it alone: the others must not be moved in its short
// parts, and a plate that bounces must keep its energy.
TEST(ExplicitStepper, FollowsStiffContactInPartsOfSubsteps) {
    Shell shell = test::stacked_plates(1, 10, 0, test::rubber);
    const Eigen::AngleAxisd tilt(0.02, Vector3d::UnitY());
    shell.position = tilt.toRotationMatrix() * shell.rest;
    shell.position.row(2).array() += 0.002 + 0.5 * test::rubber.thickness - shell.position.row(2).minCoeff();
    shell.velocity.row(2).setConstant(-1);
    StepperOptions options = explicit_steps(1e-4);
    options.contact.obstacles = {test::floor(1e11)};
    ExplicitStepper stepper(shell, options);
    const double kinetic = kinetic_energy(shell);
    int before = 0, most = 0;
    for (int i = 0; i < 100; ++i) {
        ASSERT_TRUE(stepper.begin());
        const StepResult made = stepper.solve(1);
        ASSERT_TRUE(made);
        if (i == 0) before = made.iterations;
        most = std::max(most, made.iterations);
        stepper.finish();
    }
    EXPECT_GT(most, 2 * before);
    EXPECT_GT((shell.velocity * shell.mass).z(), 0.1 * shell.mass.sum()) << "it flies away from the floor";
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 0.01 * kinetic);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-10 * kinetic);
}

// The sag of a strip that is held at one end, once it has come to rest, must be that of implicit steps.
TEST(ExplicitStepper, ComesToRestWhereStaticsDo) {
    Shell shell = test::stacked_plates(1, 5, 0, test::firm_rubber);
    for (const Index v : {0, 1, 2, 3, 4, 5}) shell.fixed[v] = 1;
    StepperOptions options = explicit_steps(5e-4, true);
    for (const TriangleEdge& side : boundary_triangle_edges(shell, shell.fixed))
        options.shell.mirrors.push_back(clamp_hinge(shell, side, hinge_stiffness(test::firm_rubber)));
    options.shell.damping.mass = 60;
    ExplicitStepper stepper(shell, options);
    advance(stepper, 2000);
    const Positions rested = shell.position;
    shell.position = shell.rest;
    shell.velocity.setZero();
    options.scheme = Scheme::implicit_euler;
    options.step = 5e-3;
    const auto implicit = make_stepper(shell, options);
    for (int i = 0; i < 200; ++i) {
        ASSERT_TRUE(implicit->begin());
        ASSERT_TRUE(implicit->solve(50));
        implicit->finish();
    }
    EXPECT_GT((rested - shell.rest).row(2).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LT((rested - shell.position).norm(), 1e-3 * (rested - shell.rest).norm());
}

// A plate that slides stops after v^2 / (2 mu g), and friction must have taken all of its kinetic energy.
TEST(ExplicitStepper, FrictionStopsAPlateAfterItsWay) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    StepperOptions options = explicit_steps(2e-4, true);
    options.contact.obstacles = {test::floor(1e6, 0.5)};
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v)
        shell.position(2, v) =
            0.5 * shell.thickness[v] -
            shell.mass[v] * 9.81 /
                column_stiffness(shell.footprint[v], shell.thickness[v], shell.young[v], 1e6);
    shell.velocity.row(0).setConstant(0.4);
    const double kinetic = kinetic_energy(shell), way = 0.4 * 0.4 / (2 * 0.5 * 9.81);
    ExplicitStepper stepper(shell, options);
    advance(stepper, 600);
    EXPECT_NEAR((shell.position - shell.rest).row(0).mean(), way, 0.02 * way);
    EXPECT_NEAR(stepper.balance().lost_to_friction, kinetic, 0.02 * kinetic);
    EXPECT_LT(linear_momentum(shell).head<2>().norm(), 1e-3 * shell.mass.sum() * 0.4);
}

RigidBody steel_ball(const Vector3d& centre, const Vector3d& velocity) {
    RigidBody ball = rigid_sphere(0.01, 7850);
    ball.centre = centre;
    ball.velocity = velocity;
    return ball;
}

// A plate throws a ball back: momentum must pass to the plate, and energy be kept.
TEST(ExplicitStepper, ABallAndAPlateExchangeMomentumAndKeepEnergy) {
    Shell shell = test::stacked_plates(1, 8, 0, test::glass);
    RigidBody ball = steel_ball(Vector3d(0.011, 0.007, 0.0122), Vector3d(0.5, 0, -2));
    ball.surface = test::sphere_surface(0.01, 2);
    ball.angular_momentum = ball.inertia.asDiagonal() * Vector3d(30, 0, 10);
    StepperOptions options = explicit_steps(2e-6);
    options.contact.bodies = {ball};
    ExplicitStepper stepper(shell, options);
    advance(stepper, 600);
    const RigidBody& after = stepper.bodies().front();
    EXPECT_GT(after.velocity.z(), -1.9) << "they have not met";
    const Vector3d total = linear_momentum(shell) + ball.mass * after.velocity;
    EXPECT_LT((total - ball.mass * ball.velocity).norm(), 1e-10 * ball.mass * 2);
    const Vector3d turning =
        angular_momentum(shell) + after.mass * after.centre.cross(after.velocity) + after.angular_momentum;
    const Vector3d before = ball.mass * ball.centre.cross(ball.velocity) + ball.angular_momentum;
    EXPECT_LT((turning - before).norm(), 1e-6 * before.norm());
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 5e-3 * ball.kinetic_energy());
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-10 * ball.kinetic_energy());
}

// A ball that is out of reach when a step begins, and meets the plate within it, must push the plate as the
// plate pushes it. Only vertices within reach are followed in a step.
TEST(ExplicitStepper, ABallMeetsAPlateWithinALongStep) {
    Shell shell = test::stacked_plates(1, 8, 0, test::glass);
    const RigidBody ball = steel_ball(Vector3d(0, 0, 0.0121 + 1e-5), Vector3d(0, 0, -10));
    StepperOptions options = explicit_steps(1e-4);
    options.contact.bodies = {ball};
    ExplicitStepper stepper(shell, options);
    advance(stepper, 1);
    const RigidBody& after = stepper.bodies().front();
    EXPECT_GT(after.velocity.z(), -9.99) << "they have not met";
    const Vector3d total = linear_momentum(shell) + ball.mass * after.velocity;
    EXPECT_LT((total - ball.mass * ball.velocity).norm(), 1e-10 * ball.mass * 10);
    advance(stepper, 5);
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 5e-3 * ball.kinetic_energy());
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-10 * ball.kinetic_energy());
}

// The work of weight on bodies must be zero before the first substep, whatever was in the memory before.
TEST(ExplicitStepper, TheBalanceOfFallingBodiesBeginsAtNothing) {
    for (const std::size_t count : {1, 2, 3, 5}) {
        { const std::vector<std::vector<double>> dirt(64, std::vector<double>(6 * count, 1e200)); }
        Shell shell = test::stacked_plates(1, 4, 0, test::glass);
        RigidBody ball = rigid_sphere(0.01, 7850);
        StepperOptions options = explicit_steps(2e-6);
        options.gravity = Vector3d(0, 0, -9.81);
        for (std::size_t i = 0; i < count; ++i) {
            ball.centre = Vector3d(0, 0, 1.0 + 0.1 * static_cast<double>(i));
            options.contact.bodies.push_back(ball);
        }
        ExplicitStepper stepper(shell, options);
        advance(stepper, 3);
        EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-12) << count;
    }
}

// A plate on a peg between its vertices: friction acts on the peg's surface, with the coefficient times the
// contact force. With friction at vertices alone the plate would slide freely.
TEST(ExplicitStepper, FrictionOnABodyBetweenVerticesIsTheCoefficientTimesThePressure) {
    Shell shell = test::stacked_plates(1, 4, 0, test::glass);
    RigidBody peg = rigid_box(Vector3d(6e-3, 5e-3, 8e-3), 2e6);
    peg.surface = test::box_surface(Vector3d::Zero(), Vector3d(3e-3, 2.5e-3, 4e-3));
    peg.centre = Vector3d(0.013, 0.01, -4e-3 - 1.1e-3);
    peg.friction = 0.3;
    shell.velocity.row(0).setConstant(2);
    shell.velocity.row(2).setConstant(-0.2);
    StepperOptions options = explicit_steps(2e-6);
    options.contact.bodies = {peg};
    ExplicitStepper stepper(shell, options);
    const Vector3d momentum = linear_momentum(shell);
    const double kinetic = kinetic_energy(shell);
    advance(stepper, 1000);
    const Vector3d given = peg.mass * stepper.bodies().front().velocity;
    EXPECT_LT(given.z(), -0.05 * shell.mass.sum()) << "they have not met";
    EXPECT_NEAR(given.x(), -0.3 * given.z(), 1e-3 * given.x());
    EXPECT_LT((linear_momentum(shell) + given - momentum).norm(), 1e-10 * momentum.norm());
    EXPECT_NEAR(stepper.balance().lost_to_friction, 2 * given.x(), 0.1 * given.x());
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-6 * kinetic);
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 1e-3 * kinetic);
}

// Cracks that exist at the start open before the first step. Then forces are evaluated before any step has
// begun, which must leave no trace.
TEST(ExplicitStepper, AChangeOfTheShellBeforeTheFirstStepLeavesNoTrace) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    shell.velocity.row(1).setConstant(2);
    StepperOptions options = explicit_steps(1e-4, true);
    options.shell.damping = {.stiffness = 1e-5, .mass = 30};
    Shell other = shell;
    ExplicitStepper stepper(shell, options), changed(other, options);
    changed.topology_changed({});
    advance(stepper, 3);
    advance(changed, 3);
    EXPECT_EQ(shell.position, other.position);
    EXPECT_EQ(stepper.balance().lost_to_damping, changed.balance().lost_to_damping);
}

// A plate that is thrown at another one stops, and the other one continues.
TEST(ExplicitStepper, PlatesDoNotPassButExchangeTheirVelocity) {
    Shell shell = test::stacked_plates(2, 4, 4.2e-3, test::glass);
    const Index half = static_cast<Index>(shell.mass.size()) / 2;
    shell.velocity.rightCols(half).row(2).setConstant(-1);
    StepperOptions options = explicit_steps(2e-6);
    options.contact.sheets = true;
    ExplicitStepper stepper(shell, options);
    const Vector3d momentum = linear_momentum(shell);
    const double kinetic = kinetic_energy(shell);
    double nearest = 1;
    for (int i = 0; i < 250; ++i) {
        advance(stepper, 1);
        nearest = std::min(nearest, test::smallest_distance(shell, shell.position));
    }
    EXPECT_LT(nearest, 4e-3) << "they have not met";
    EXPECT_GT(nearest, 1e-3);
    EXPECT_LT((linear_momentum(shell) - momentum).norm(), 1e-11 * momentum.norm());
    EXPECT_NEAR(shell.velocity.rightCols(half).row(2).mean(), 0, 0.05);
    EXPECT_NEAR(shell.velocity.leftCols(half).row(2).mean(), -1, 0.05);
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 0.02 * kinetic);
}

// Vertices with a prescribed motion must follow it, and the balance must include the work of this motion.
TEST(ExplicitStepper, PinsThatMoveArriveAndWork) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    Motion motion;
    motion.keys = {{0}, {0.02, Vector3d(0, 0, 0.01)}};
    shell.motions.push_back(motion);
    for (const Index v : {0, 4}) {
        shell.fixed[v] = 1;
        shell.script[v] = 1;
    }
    ExplicitStepper stepper(shell, explicit_steps(1e-4, true));
    advance(stepper, 200);
    EXPECT_NEAR(shell.position(2, 4), 0.01, 1e-12);
    const double energy = stepper.balance().work_of_supports;
    EXPECT_GT(energy, 0);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-9 * energy);
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 0.02 * energy);
}

/// Plate that is held on one side and pulled on the opposite side to twice its length in 0.2 s.
Shell pulled_plate() {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    Motion still, motion;
    still.keys = {{0}};
    motion.keys = {{0}, {0.2, Vector3d(0.1, 0, 0)}};
    shell.motions = {still, motion};
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v)
        if (std::abs(shell.rest(0, v)) > 0.049) {
            shell.fixed[v] = 1;
            shell.script[v] = shell.rest(0, v) < 0 ? 1 : 2;
        }
    return shell;
}

// A stretched plate is stiffer: a substep that was short enough at rest would become too long, and positions
// would diverge.
TEST(ExplicitStepper, WhatIsStretchedToTwiceItsLengthStaysStable) {
    Shell shell = pulled_plate();
    ExplicitStepper stepper(shell, explicit_steps(1e-3));
    advance(stepper, 1);
    const double at_rest = stepper.substep();
    advance(stepper, 219);
    EXPECT_LT(stepper.substep(), 0.6 * at_rest);
    const double work = stepper.balance().work_of_supports;
    EXPECT_GT(work, 0);
    EXPECT_LT(std::abs(stepper.balance().lost_to_scheme), 1e-3 * work);
    EXPECT_LT(kinetic_energy(shell), 0.01 * work);
}

// A plate that comes near in one long step, but is thrown back, must not count as having passed.
TEST(ExplicitStepper, AStepFromFarAwayIntoContactIsNoPassage) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    shell.position.row(2).array() += 12e-3;
    shell.velocity.row(2).setConstant(-1);
    StepperOptions options = explicit_steps(11.02e-3);
    options.contact.obstacles = {test::solid_box({0, 0, -0.02}, {0.08, 0.08, 0.02}, 1e9)};
    ExplicitStepper stepper(shell, options);
    advance(stepper, 1);
    EXPECT_LT(shell.position.row(2).maxCoeff(), 1.05e-3);
    advance(stepper, 1);
    EXPECT_GT(shell.velocity.row(2).mean(), 0.5);
}

// In one step the tray moves by more than the plate's thickness, which must not count as a passage. The tray
// stands at an angle from the start, when friction has no velocity yet.
TEST(ExplicitStepper, ATrayThatMovesFastLiftsAPlate) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    Obstacle tray = test::solid_box({0, 0, -0.02}, {0.08, 0.08, 0.02}, 1e9, 0.5);
    const Vector3d place(0.37, -0.21, 0.13);
    tray.motion.smooth = false;
    tray.motion.keys = {{0, place, Vector3d::UnitZ(), 0.3},
                        {0.02, place + Vector3d(0, 0, 0.1), Vector3d::UnitZ(), 0.3}};
    shell.position.colwise() += place + Vector3d(0, 0, 0.99e-3);
    StepperOptions options = explicit_steps(1e-3, true);
    options.contact.obstacles = {tray};
    ExplicitStepper stepper(shell, options);
    advance(stepper, 20);
    EXPECT_GT(shell.position.row(2).minCoeff(), 0.13 + 0.1);
    EXPECT_GT(stepper.balance().work_of_obstacles, 0.5 * shell.mass.sum() * 5 * 5);
    EXPECT_LT(std::abs(stepper.balance().unexplained), 1e-10 * kinetic_energy(shell));
}

}  // namespace
}  // namespace sherd
