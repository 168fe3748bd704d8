// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/given_forces.h"

#include <gtest/gtest.h>

#include "tests/support/shell/materials.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

Positions some_forces(const Shell& shell) {
    Positions forces = Positions::Zero(3, shell.position.cols());
    forces.col(0) = Vector3d(1, 2, 3);
    forces.col(1) = Vector3d(-4, 0, 5);
    return forces;
}

Positions force_of(const GivenForces& energy, const Shell& shell) {
    Positions gradient = Positions::Zero(3, shell.position.cols());
    energy.add_gradient(shell.position, gradient);
    return -gradient;
}

// A force of wrong size or sign would push a sheet that a program controls in a wrong way.
TEST(GivenForces, ActAsTheyAreGivenAndWork) {
    const Shell shell = test::two_triangles(test::thick_foam);
    GivenForces energy(shell);
    energy.begin({});
    EXPECT_TRUE(force_of(energy, shell).isZero(0));
    const Positions forces = some_forces(shell);
    energy.give(forces);
    energy.begin({});
    EXPECT_TRUE(force_of(energy, shell).isApprox(forces, 1e-14));
    Positions moved = shell.position;
    moved.col(0) += Vector3d(0.1, 0, 0.2);
    EXPECT_NEAR(energy.value(moved), -(0.1 * 1 + 0.2 * 3), 1e-14);
    StepContext half;
    half.load = 0.5;
    energy.begin(half);
    EXPECT_TRUE(force_of(energy, shell).isApprox(0.5 * forces, 1e-14));
}

// Where a crack opens, the force must neither double nor be lost.
TEST(GivenForces, CopiesOfAVertexShareThemByMass) {
    Shell shell = test::two_triangles(test::thick_foam);
    GivenForces energy(shell);
    const Positions forces = some_forces(shell);
    energy.give(forces);
    energy.begin({});
    const auto copy = static_cast<Index>(shell.position.cols());
    const double mass = shell.mass[0];
    ShellChange change;
    change.vertices = {{copy, {{0, 1.0}}}};
    follow(shell, change);
    shell.mass[0] = 0.25 * mass;
    shell.mass[copy] = 0.75 * mass;
    energy.topology_changed(change, {});
    const Positions shared = force_of(energy, shell);
    EXPECT_TRUE(shared.col(0).isApprox(0.25 * forces.col(0), 1e-14));
    EXPECT_TRUE(shared.col(copy).isApprox(0.75 * forces.col(0), 1e-14));
    EXPECT_TRUE(shared.col(1).isApprox(forces.col(1), 1e-14));
}

}  // namespace
}  // namespace sherd
