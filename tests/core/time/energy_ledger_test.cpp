// SPDX-License-Identifier: GPL-3.0-or-later
// Each term of the energy balance is compared with a sum by hand: in the total alone, two opposite faults
// would cancel.
#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

constexpr double fall = 9.81;  // m/s^2

StepperOptions exact_steps(double step) {
    StepperOptions options;
    options.step = step;
    options.tolerance = 1e-12;
    return options;
}

const EnergyBalance& after_steps(ImplicitStepper& stepper, int steps) {
    for (int i = 0; i < steps; ++i) test::advance(stepper);
    return stepper.balance();
}

Motion upwards(double speed) {
    Motion motion;
    motion.smooth = false;
    motion.keys = {{0}, {1, Vector3d(0, 0, speed)}};
    return motion;
}

// In free fall implicit Euler loses half the mass times the square of the change of velocity in each step.
TEST(EnergyLedger, InFreeFallTheSchemeTakesWhatTheoryTells) {
    Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    ImplicitStepper stepper(shell, exact_steps(1e-3));
    const double mass = shell.mass.sum();
    const EnergyBalance& balance = after_steps(stepper, 20);
    EXPECT_NEAR(balance.lost_to_scheme, 20 * 0.5 * mass * std::pow(fall * 1e-3, 2), 1e-9 * mass);
    EXPECT_LT(std::abs(balance.unexplained), 1e-12 * mass);
    for (const auto part : {&EnergyBalance::work_of_supports, &EnergyBalance::work_of_obstacles,
                            &EnergyBalance::lost_to_friction, &EnergyBalance::lost_to_cracks})
        EXPECT_EQ(balance.*part, 0);
}

// Pins that lift a plate work against its weight. They give the plate its velocity within one step, by twice
// the work of its kinetic energy: half of that work is lost to the scheme.
TEST(EnergyLedger, PinsThatLiftAPlateWorkAgainstItsWeight) {
    Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    shell.motions.push_back(upwards(0.5));
    for (char& fixed : shell.fixed) fixed = 1;
    for (Index& script : shell.script) script = 1;
    ImplicitStepper stepper(shell, exact_steps(1e-3));
    const double mass = shell.mass.sum(), kinetic = 0.5 * mass * 0.25;
    const EnergyBalance& balance = after_steps(stepper, 30);
    EXPECT_NEAR(balance.work_of_supports, mass * fall * 0.5 * 0.03 + 2 * kinetic, 1e-9 * kinetic);
    EXPECT_NEAR(balance.lost_to_scheme, kinetic, 1e-9 * kinetic);
    EXPECT_LT(std::abs(balance.unexplained), 1e-9 * kinetic);
}

// The work of a clamp that turns a strip, whose other vertices are free, must be in the balance.
TEST(EnergyLedger, AClampThatTurnsWorks) {
    Shell shell = test::stacked_plates(1, 4, 0, test::firm_rubber);
    Motion motion;
    motion.keys = {{0}, {0.1, Vector3d(0, 0, 0.02), Vector3d::UnitX(), 1.5}};
    motion.pivot = shell.rest.col(2);
    shell.motions.push_back(motion);
    for (const Index v : {0, 1, 2, 3, 4}) shell.fixed[v] = 1;
    for (const Index v : {0, 1, 2, 3, 4}) shell.script[v] = 1;
    StepperOptions options = exact_steps(1e-3);
    for (const TriangleEdge& side : boundary_triangle_edges(shell, shell.fixed))
        options.shell.mirrors.push_back(clamp_hinge(shell, side, hinge_stiffness(test::firm_rubber)));
    for (MirrorHinge& mirror : options.shell.mirrors) mirror.script = 1;
    for (const BendingModel model : {BendingModel::cubic, BendingModel::coupled}) {
        Shell turned = shell;
        options.shell.bending.model = model;
        ImplicitStepper stepper(turned, options);
        const EnergyBalance& balance = after_steps(stepper, 60);
        EXPECT_GT(balance.work_of_supports, 1e-3);
        EXPECT_LT(std::abs(balance.unexplained), 1e-9 * balance.work_of_supports);
        // The scheme's loss is the error of the rectangle rule, half a step of a changing force: small
        // beside the work.
        EXPECT_LT(std::abs(balance.lost_to_scheme), 0.2 * balance.work_of_supports);
    }
}

// The work of a floor that rises under a plate must be in the balance.
TEST(EnergyLedger, AnObstacleThatLiftsAPlateWorks) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    shell.position.row(2).setConstant(0.5 * test::rubber.thickness);
    StepperOptions options = exact_steps(1e-3);
    options.contact.obstacles = {test::floor()};
    options.contact.obstacles[0].motion = upwards(0.2);
    ImplicitStepper stepper(shell, options);
    const double mass = shell.mass.sum(), lifted = mass * fall * 0.2 * 0.2;
    const EnergyBalance& balance = after_steps(stepper, 200);
    EXPECT_NEAR(balance.work_of_obstacles, lifted + mass * 0.2 * 0.2, 0.02 * lifted);
    EXPECT_LT(std::abs(balance.unexplained), 1e-9 * lifted);
}

// A plate that slides is slowed down by its weight times the coefficient of friction.
TEST(EnergyLedger, FrictionTakesItsForceTimesTheWay) {
    Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    const double coefficient = 0.3, mass = shell.mass.sum();
    StepperOptions options = exact_steps(1e-4);
    options.contact.obstacles = {test::floor(1e6, coefficient)};
    const Index vertices = static_cast<Index>(shell.mass.size());
    for (Index v = 0; v < vertices; ++v)  // each vertex is as deep as its weight presses it
        shell.position(2, v) =
            0.5 * shell.thickness[v] -
            shell.mass[v] * fall /
                column_stiffness(shell.footprint[v], shell.thickness[v], shell.young[v], 1e6);
    shell.velocity.row(0).setConstant(1);
    ImplicitStepper stepper(shell, options);
    const EnergyBalance& balance = after_steps(stepper, 500);
    const double way = (shell.position - shell.rest).row(0).mean();
    EXPECT_GT(way, 0.04);
    EXPECT_NEAR(balance.lost_to_friction, coefficient * mass * fall * way, 0.01 * balance.lost_to_friction);
    EXPECT_LT(std::abs(balance.unexplained), 1e-9 * balance.lost_to_friction);
}

// Damping by the medium, with the coefficient c, reduces the velocity v to v / (1 + c h) in each step of h,
// and takes the work of the force c m v over the distance v h.
TEST(EnergyLedger, DampingTakesItsForceTimesTheWay) {
    Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    shell.velocity.row(1).setConstant(2);
    StepperOptions options = exact_steps(1e-3);
    options.gravity.setZero();
    options.shell.damping.mass = 30;
    ImplicitStepper stepper(shell, options);
    const double mass = shell.mass.sum();
    double expected = 0, speed = 2;
    for (int i = 0; i < 20; ++i) {
        speed /= 1 + 30 * 1e-3;
        expected += 30 * mass * speed * speed * 1e-3;
    }
    EXPECT_NEAR(after_steps(stepper, 20).lost_to_damping, expected, 1e-9 * expected);
}

// The work of dead loads on a free plate must be the force times the plate's displacement.
TEST(EnergyLedger, LoadsWorkAlongTheWay) {
    Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    StepperOptions options = exact_steps(1e-3);
    options.gravity.setZero();
    std::vector<Index> triangles(shell.triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) triangles[t] = static_cast<Index>(t);
    Load load;
    load.spread = area_forces(shell, triangles, Vector3d(0, 100, 0));
    options.shell.loads = {load};
    ImplicitStepper stepper(shell, options);
    const EnergyBalance& balance = after_steps(stepper, 20);
    const double way = (shell.position - shell.rest).row(1).mean(), force = 100 * 0.1 * 0.1;
    EXPECT_GT(way, 1e-3);
    EXPECT_NEAR(balance.work_of_loads, force * way, 1e-6 * force * way);
}

class HingeThatFails : public ::testing::Test {
  protected:
    void SetUp() override {
        shell.position(2, 3) = 0.4;
        StepperOptions options = exact_steps(1e-3);
        options.gravity.setZero();
        options.shell.bending.model = BendingModel::cubic;
        stepper.emplace(shell, options);
    }
    void solve() {
        ASSERT_TRUE(stepper->begin());
        ASSERT_TRUE(stepper->solve(200));
    }
    void fail() {
        shell.hinges.clear();
        shell.edge_hinge = {-1};
        shell.hinge_edge.clear();
        ShellChange change;
        change.removed_hinges = {0};
        stepper->topology_changed(change);
    }
    void expect_lost(double energy) const {
        EXPECT_NEAR(stepper->balance().lost_to_cracks, energy, 1e-9 * energy);
        EXPECT_LT(std::abs(stepper->balance().unexplained), 1e-9 * energy);
    }

    Shell shell = test::two_triangles(test::rubber);
    std::optional<ImplicitStepper> stepper;
};

// A hinge that fails removes its own energy from the balance, and no other.
TEST_F(HingeThatFails, TakesItsEnergy) {
    solve();
    const double bent = stepper->energies().bending;
    EXPECT_GT(bent, 1e-6);
    fail();
    ASSERT_TRUE(stepper->solve(200));
    stepper->finish();
    expect_lost(bent);
}

// If a step is begun again after a hinge failed in it, only the failure remains: the balance loses the
// energy that the hinge had at the beginning of the step.
TEST_F(HingeThatFails, CountsOnceInAStepThatIsBegunAgain) {
    const double bent = stepper->energies().bending;
    solve();
    fail();
    test::advance(*stepper);
    expect_lost(bent);
}

// A body that spins about a non-principal axis and meets a plate: the balance must include all that both
// exchange.
TEST(EnergyLedger, ClosesWithABodyThatSpinsIntoAPlate) {
    Shell shell = test::stacked_plates(1, 4, 0, test::rubber);
    shell.fixed[0] = shell.fixed[4] = shell.fixed[20] = shell.fixed[24] = 1;
    RigidBody box = rigid_box(Vector3d(0.02, 0.01, 0.03), 2000);
    box.centre = Vector3d(0, 0, 0.03);
    box.velocity = Vector3d(0.3, 0, -1);
    box.angular_momentum = box.inertia.asDiagonal() * Vector3d(20, -30, 10);
    box.friction = 0.4;
    StepperOptions options = exact_steps(5e-4);
    options.contact.bodies = {box};
    ImplicitStepper stepper(shell, options);
    const EnergyBalance& balance = after_steps(stepper, 80);
    EXPECT_GT(balance.lost_to_friction, 0);
    EXPECT_LT(std::abs(balance.unexplained), 1e-7 * box.kinetic_energy());
}

}  // namespace
}  // namespace sherd
