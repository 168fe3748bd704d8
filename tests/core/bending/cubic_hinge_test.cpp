// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/cubic_hinge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

constexpr double bend_stiffness = 1.7;

TEST(CubicHinge, HasNoForceAtRestHoweverCurved) {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const HingePositions rest = random_hinge(random, random.uniform(-2.6, 2.6));
        const CubicHinge hinge = cubic_hinge(rest, bend_stiffness);
        EXPECT_LT(gradient(hinge, rest).norm(), 1e-11 * hinge.quadratic.norm() * rest.norm());
        EXPECT_NEAR(value(hinge, rest), 0, 1e-12 * hinge.quadratic.norm());
    }
}

// Newton's method uses the quadratic part where the exact Hessian is indefinite.
TEST(CubicHinge, QuadraticPartIsPositiveSemidefinite) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const CubicHinge hinge = cubic_hinge(random_hinge(random, random.uniform(-2.6, 2.6)), bend_stiffness);
        const VectorXd eigenvalues = test::eigenvalues(hinge.quadratic);
        EXPECT_GT(eigenvalues[0], -1e-12 * eigenvalues[3]);
    }
}

// The correction of the form of 2007 must be a sum over squared edge lengths, which no isometry changes: no
// term may join the apexes 2 and 3, between which there is no edge.
TEST(CubicHinge, QuadraticCorrectionIsMadeOfEdgeLengths) {
    Random random(6);
    for (int i = 0; i < 200; ++i) {
        const HingePositions rest = random_hinge(random, random.uniform(-2.6, 2.6));
        const CubicHinge paper = cubic_hinge_2007(rest, bend_stiffness),
                         hinge = cubic_hinge(rest, bend_stiffness);
        const Eigen::Matrix4d added = hinge.quadratic - paper.quadratic;
        EXPECT_EQ(added(2, 3), 0);
        EXPECT_LT((added * Eigen::Vector4d::Ones()).norm(), 1e-14 * hinge.quadratic.norm());
        EXPECT_EQ(hinge.cubic, paper.cubic);
    }
}

// For flat rest shapes both forms of the cubic shell, of 2007 and corrected, are the quadratic model, 3
// lambda / (2 A) |K x|^2, with the stiffness lambda and the area A of both triangles.
TEST(CubicHinge, IsTheQuadraticModelWhereTheRestShapeIsFlat) {
    Random random(7);
    for (int i = 0; i < 200; ++i) {
        const HingePositions rest = random_hinge(random, 0), x = random_hinge(random, random.uniform(-3, 3));
        const RestHinge geometry = rest_hinge(rest);
        const Eigen::Vector4d& c = geometry.cotangents;
        const Eigen::Vector4d K(c[1] + c[3], c[0] + c[2], -c[0] - c[1], -c[2] - c[3]);
        const double expected = 1.5 * bend_stiffness / geometry.area * (x * K).squaredNorm();
        for (const CubicHinge& hinge :
             {cubic_hinge(rest, bend_stiffness), cubic_hinge_2007(rest, bend_stiffness)}) {
            EXPECT_LT(std::abs(hinge.cubic), 1e-13 * hinge.quadratic.norm());
            EXPECT_NEAR(value(hinge, x), expected, 1e-12 * hinge.quadratic.norm() * x.squaredNorm());
        }
    }
}

// The form of 2007 has forces at a curved rest shape, as is known; the correction removes them.
TEST(CubicHinge, FormOf2007HasAForceAtRestWhereItIsCurved) {
    const HingePositions rest = test::folded_hinge(1, 0.4, 0.7, 0.2, 1.1);
    EXPECT_NEAR(value(cubic_hinge_2007(rest, bend_stiffness), rest), 0, 1e-14);
    EXPECT_GT(gradient(cubic_hinge_2007(rest, bend_stiffness), rest).norm(), 0.1);
}

TEST(Hinge, AngleHasTheSignOfTheTripleProductUpToLargeFolds) {
    for (double angle = -3.1; angle < 3.1; angle += 0.05)
        EXPECT_NEAR(hinge_angle(test::folded_hinge(angle, 0.4, 0.7, 0.2, 1.1)), angle, 1e-14);
}

TEST(Hinge, StrainIsTheChangeOfAngleOverTheHeightOfTheHinge) {
    const RestHinge rest = rest_hinge(test::folded_hinge(3.0, 0.4, 0.7, 0.2, 1.1));
    EXPECT_NEAR(rest.area, 0.9, 1e-15);
    EXPECT_NEAR(hinge_strain(rest, test::folded_hinge(2.5, 0.4, 0.7, 0.2, 1.1)), -0.5 / 0.9, 1e-13);
    // From 3.0 rad the hinge folds through pi, flat onto itself, to -3.0 rad: the change is 2 pi - 6, not
    // -6.
    EXPECT_NEAR(hinge_strain(rest, test::folded_hinge(-3.0, 0.4, 0.7, 0.2, 1.1)),
                (2 * std::acos(-1.0) - 6) / 0.9, 1e-13);
}

}  // namespace
}  // namespace sherd
