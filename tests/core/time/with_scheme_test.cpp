// SPDX-License-Identifier: GPL-3.0-or-later
// A run may continue with another time scheme: no state of the run may be lost at the change.
#include <gtest/gtest.h>

#include "core/time/stepper.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd::test {
namespace {

void advance(Stepper& stepper, int steps, double length) {
    for (int i = 0; i < steps; ++i) {
        ASSERT_TRUE(stepper.begin(length));
        ASSERT_TRUE(stepper.solve(200));
        stepper.finish();
    }
}

/// Two plates far apart that fly, spin and vibrate, and a ball.
struct Flight {
    Flight() {
        for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v) {
            const Vector3d at = shell.position.col(v);
            shell.velocity.col(v) = Vector3d(1, 2, 3) + Vector3d(0, 0, 20).cross(at);
            shell.velocity(2, v) += 0.1 * std::cos(30 * at.x());
        }
        options.step = 2e-5;
        options.tolerance = 1e-12;
        options.shell.damping = {1e-7, 0};
        options.contact.sheets = true;
        RigidBody ball = rigid_sphere(0.01, 1000);
        ball.centre = {0, 0, 1};
        ball.velocity = {4, 0, 0};
        options.contact.bodies = {ball};
        stepper = make_stepper(shell, options);
    }
    double energy() const {
        double sum = kinetic_energy(shell) + stepper->energies().stored() + stepper->energies().gravity;
        for (const RigidBody& body : stepper->bodies()) sum += body.kinetic_energy();
        return sum;
    }

    Shell shell = stacked_plates(2, 5, 0.1, test::glass);
    StepperOptions options;
    std::unique_ptr<Stepper> stepper;
};

TEST(WithScheme, GoesOnWhereTheOtherEnded) {
    Flight flight;
    advance(*flight.stepper, 5, 2e-5);
    const Positions position = flight.shell.position, velocity = flight.shell.velocity;
    const EnergyBalance before = flight.stepper->balance();
    for (const Scheme scheme : {Scheme::explicit_differences, Scheme::implicit_euler}) {
        flight.stepper = with_scheme(std::move(flight.stepper), scheme);
        EXPECT_EQ(flight.stepper->scheme(), scheme);
        EXPECT_EQ(flight.stepper->position, position);
        EXPECT_EQ(flight.shell.velocity, velocity);
        EXPECT_EQ(flight.stepper->balance().lost_to_damping, before.lost_to_damping);
    }
}

// Time, the ball, damping and the balance must pass to the stepper of the next scheme.
TEST(WithScheme, KeepsTheBalanceTheBodiesAndTheTime) {
    Flight flight;
    const double start = flight.energy();
    const Vector3d momentum = linear_momentum(flight.shell);
    for (const Scheme scheme :
         {Scheme::explicit_differences, Scheme::implicit_euler, Scheme::explicit_differences}) {
        advance(*flight.stepper, 5, 2e-5);
        flight.stepper = with_scheme(std::move(flight.stepper), scheme);
    }
    advance(*flight.stepper, 5, 2e-5);
    const EnergyBalance& balance = flight.stepper->balance();
    EXPECT_GT(balance.lost_to_damping, 0);
    EXPECT_LT(std::abs(balance.unexplained), 1e-9 * start);
    EXPECT_NEAR(flight.energy(), start - balance.lost_to_damping - balance.lost_to_scheme, 1e-9 * start);
    EXPECT_NEAR(flight.stepper->bodies()[0].centre.x(), 4 * 20 * 2e-5, 1e-12);
    const Vector3d fallen = momentum + 20 * 2e-5 * flight.shell.mass.sum() * flight.options.gravity;
    EXPECT_LT((linear_momentum(flight.shell) - fallen).norm(), 1e-10 * momentum.norm());
}

// Springs store a different contact energy than a barrier: the balance must include the difference.
TEST(WithScheme, TheBalanceHasWhatContactStoresOtherwise) {
    Shell shell = stacked_plates(2, 5, 0.0021, {1000, 0.002, 1e7, 0.2});
    shell.velocity.row(2).tail(shell.mass.size() / 2).setConstant(-0.5);
    shell.velocity.row(2).head(shell.mass.size() / 2).setZero();
    StepperOptions options;
    options.gravity.setZero();
    options.tolerance = 1e-12;
    options.contact.sheets = true;
    std::unique_ptr<Stepper> stepper = make_stepper(shell, options);
    const double start = kinetic_energy(shell);
    for (int i = 0; i < 40 && stepper->energies().contact == 0; ++i) advance(*stepper, 1, 2e-5);
    ASSERT_GT(stepper->energies().contact, 0);
    for (const Scheme scheme : {Scheme::explicit_differences, Scheme::implicit_euler}) {
        stepper = with_scheme(std::move(stepper), scheme);
        advance(*stepper, 3, 2e-5);
        EXPECT_LT(std::abs(stepper->balance().unexplained), 1e-8 * start);
        EXPECT_NEAR(kinetic_energy(shell) + stepper->energies().stored(),
                    start - stepper->balance().lost_to_scheme, 1e-8 * start);
    }
}

// Pieces may separate after the last step of one scheme and before the first step of the next. Then a
// stepper that has not begun any step is told of the change, and must not read the uninitialised motion of
// free bodies.
TEST(WithScheme, AStepperThatHasNotBegunHearsOfChanges) {
    for (const Scheme scheme : {Scheme::explicit_differences, Scheme::implicit_euler, Scheme::bdf2}) {
        Flight told, untold;
        for (Flight* flight : {&told, &untold}) {
            flight->options.scheme = scheme;
            flight->stepper = make_stepper(flight->shell, flight->options);
        }
        told.stepper->topology_changed({});
        EXPECT_EQ(told.energy(), untold.energy());
        advance(*told.stepper, 3, 2e-5);
        advance(*untold.stepper, 3, 2e-5);
        EXPECT_EQ(told.shell.position, untold.shell.position);
        EXPECT_EQ(told.stepper->bodies()[0].centre, untold.stepper->bodies()[0].centre);
    }
}

}  // namespace
}  // namespace sherd::test
