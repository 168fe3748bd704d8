// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/nonlinear_hinge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

// The force must be exactly zero: otherwise a sheet at rest would creep.
TEST(NonlinearHinge, HasNoForceAtRestHoweverCurved) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const HingePositions rest = test::random_hinge(random, random.uniform(-3.1, 3.1));
        const NonlinearHinge hinge = nonlinear_hinge(rest, 1.7);
        EXPECT_EQ(value(hinge, rest), 0);
        EXPECT_EQ(gradient(hinge, rest).norm(), 0);
    }
}

// Newton's method uses the convex Hessian where the exact one is indefinite. At rest both must be equal.
TEST(NonlinearHinge, ConvexHessianIsPositiveSemidefiniteAndExactAtRest) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const HingePositions rest = test::random_hinge(random, random.uniform(-2.6, 2.6));
        const NonlinearHinge hinge = nonlinear_hinge(rest, 1.7);
        const HingeHessian convex = hessian(hinge, test::random_hinge(random, random.uniform(-3, 3)), true);
        const VectorXd eigenvalues = test::eigenvalues(convex);
        EXPECT_GE(eigenvalues[0], -1e-14 * eigenvalues[11]);
        EXPECT_LT((hessian(hinge, rest, true) - hessian(hinge, rest)).norm(),
                  1e-14 * hessian(hinge, rest).norm());
    }
}

// 1 - cos of a small angle must keep its digits: most hinges of a stiff sheet turn by 1e-6 and less.
TEST(NonlinearHinge, SmallTurnsKeepTheirEnergy) {
    for (const double rest_angle : {0.0, 1.0, -2.5}) {
        const NonlinearHinge hinge = nonlinear_hinge(test::folded_hinge(rest_angle, 0.4, 0.7, 0.2, 1.1), 1.7);
        const double turn = 1e-7, energy = 3 * 1.7 / 0.9 * 0.5 * turn * turn;
        EXPECT_NEAR(value(hinge, test::folded_hinge(rest_angle + turn, 0.4, 0.7, 0.2, 1.1)), energy,
                    1e-8 * energy);
    }
}

}  // namespace
}  // namespace sherd
