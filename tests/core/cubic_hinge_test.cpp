// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cubic_hinge.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/support/finite_differences.h"
#include "tests/support/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

constexpr double stiffness = 1.7;

/// Eq. 4 of the paper: what the cubic hinge must be along isometric deformations.
double nonlinear_energy(const RestHinge& rest, double angle) {
    return stiffness * 3 * rest.edge_length * rest.edge_length / rest.area *
           (1 - std::cos(angle - rest.angle));
}

double net_torque(const HingePositions& forces, const HingePositions& x) {
    Vector3d torque = Vector3d::Zero();
    for (int i = 0; i < 4; ++i) torque += Vector3d(x.col(i)).cross(Vector3d(forces.col(i)));
    return torque.norm();
}

// A wrong sign or factor in the forces would show here.
TEST(CubicHinge, GradientIsTheDerivativeOfTheValue) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const CubicHinge hinge = cubic_hinge(random_hinge(random, random.uniform(-2.6, 2.6)), stiffness);
        const HingePositions x = random_hinge(random, random.uniform(-2.6, 2.6));
        const auto energy = [&](const HingePositions& at) { return value(hinge, at); };
        const HingePositions exact = gradient(hinge, x);
        const HingePositions numeric = test::difference_gradient(energy, x, 1e-4);
        EXPECT_LT((exact - numeric).norm(), 1e-7 * exact.norm());
    }
}

TEST(CubicHinge, HessianIsTheDerivativeOfTheGradient) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const CubicHinge hinge = cubic_hinge(random_hinge(random, random.uniform(-2.6, 2.6)), stiffness);
        const HingePositions x = random_hinge(random, random.uniform(-2.6, 2.6));
        const auto slope = [&](const HingePositions& at) { return gradient(hinge, at); };
        const auto exact = hessian(hinge, x);
        EXPECT_LT((exact - test::difference_hessian(slope, x, 1e-3)).norm(), 1e-7 * exact.norm());
        EXPECT_LT((exact - exact.transpose()).norm(), 1e-14 * exact.norm());
    }
}

// Folding about the edge keeps both triangles: there the cubic energy is the nonlinear hinge's.
TEST(CubicHinge, EqualsTheNonlinearHingeAlongIsometries) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const double rest_angle = random.uniform(-2.6, 2.6), angle = random.uniform(-2.6, 2.6);
        const double a0 = random.uniform(-0.3, 1.3), h0 = random.uniform(0.2, 2),
                     a1 = random.uniform(-0.3, 1.3), h1 = random.uniform(0.2, 2);
        const HingePositions rest = test::folded_hinge(rest_angle, a0, h0, a1, h1);
        const HingePositions folded = test::folded_hinge(angle, a0, h0, a1, h1);
        const RestHinge geometry = rest_hinge(rest);
        const double scale = stiffness * 3 / geometry.area;
        EXPECT_NEAR(value(cubic_hinge(rest, stiffness), random.rotation() * folded),
                    nonlinear_energy(geometry, hinge_angle(folded)),
                    1e-11 * scale * (1 + std::abs(hinge_angle(rest))));
    }
}

TEST(CubicHinge, FeelsNoForceAtRestHoweverCurved) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const HingePositions rest = random_hinge(random, random.uniform(-2.6, 2.6));
        const CubicHinge hinge = cubic_hinge(rest, stiffness);
        EXPECT_LT(gradient(hinge, rest).norm(), 1e-11 * hinge.quadratic.norm() * rest.norm());
        EXPECT_NEAR(value(hinge, rest), 0, 1e-12 * hinge.quadratic.norm());
    }
}

// Newton's method falls back on this matrix where the whole Hessian is not definite.
TEST(CubicHinge, QuadraticPartIsPositiveSemidefinite) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const CubicHinge hinge = cubic_hinge(random_hinge(random, random.uniform(-2.6, 2.6)), stiffness);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(hinge.quadratic);
        EXPECT_GT(eigen.eigenvalues()[0], -1e-12 * eigen.eigenvalues()[3]);
    }
}

TEST(CubicHinge, HasNoNetForceOrTorqueOnAnyDeformation) {
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        const CubicHinge hinge = cubic_hinge(random_hinge(random, random.uniform(-2.6, 2.6)), stiffness);
        const HingePositions x = random_hinge(random, 1) + random.matrix<HingePositions>(1);
        const HingePositions force = gradient(hinge, x);
        const double scale = hinge.quadratic.norm() * x.norm();
        EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * scale);
        EXPECT_LT(net_torque(force, x), 1e-12 * scale * x.norm());
    }
}

TEST(Hinge, AngleHasTheSignOfTheTripleProductUpToLargeFolds) {
    for (double angle = -3.1; angle < 3.1; angle += 0.05)
        EXPECT_NEAR(hinge_angle(test::folded_hinge(angle, 0.4, 0.7, 0.2, 1.1)), angle, 1e-14);
}

TEST(Hinge, StrainIsTheChangeOfAngleOverTheHeightOfTheHinge) {
    const RestHinge rest = rest_hinge(test::folded_hinge(3.0, 0.4, 0.7, 0.2, 1.1));
    EXPECT_NEAR(rest.area, 0.9, 1e-15);
    EXPECT_NEAR(hinge_strain(rest, test::folded_hinge(2.5, 0.4, 0.7, 0.2, 1.1)), -0.5 / 0.9, 1e-13);
    // Folding on through flat onto itself goes the short way round.
    EXPECT_NEAR(hinge_strain(rest, test::folded_hinge(-3.0, 0.4, 0.7, 0.2, 1.1)),
                (2 * std::acos(-1.0) - 6) / 0.9, 1e-13);
}

}  // namespace
}  // namespace sherd
