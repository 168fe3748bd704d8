// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/membrane.h"

#include <gtest/gtest.h>

#include "core/material/material.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

const Material membrane_material{1000, 0.01, 3e5, 0.3};

MembraneTriangle random_triangle(Random& random) {
    return membrane_triangle(random.matrix<TrianglePositions>(1), membrane_elasticity(membrane_material));
}

const Material cloth{1000, 0.01, 3e5, 0.3, 4e4, 2e4};

/// Triangle of cloth whose first material axis is `axis`, a direction in the triangle's plane.
MembraneTriangle cloth_triangle(const TrianglePositions& rest, const Vector3d& axis) {
    return membrane_triangle(rest, membrane_elasticity(cloth, axis_angle(rest, axis)));
}

TEST(Membrane, GradientIsTheDerivativeOfTheValue) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const MembraneTriangle triangle = random_triangle(random);
        const TrianglePositions x = random.matrix<TrianglePositions>(1);
        const auto energy = [&](const TrianglePositions& at) { return value(triangle, at); };
        const TrianglePositions exact = gradient(triangle, x);
        EXPECT_LT((exact - test::difference_gradient(energy, x, 1e-5)).norm(), 1e-7 * exact.norm());
    }
}

TEST(Membrane, HessianIsTheDerivativeOfTheGradient) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const MembraneTriangle triangle = random_triangle(random);
        const TrianglePositions x = random.matrix<TrianglePositions>(1);
        const auto slope = [&](const TrianglePositions& at) { return gradient(triangle, at); };
        const auto exact = hessian(triangle, x, false);
        EXPECT_LT((exact - test::difference_hessian(slope, x, 1e-5)).norm(), 1e-7 * exact.norm());
    }
}

TEST(Membrane, ConvexHessianIsPositiveSemidefiniteAndExactInTension) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const TrianglePositions rest = random.matrix<TrianglePositions>(1);
        const MembraneTriangle triangle = membrane_triangle(rest, membrane_elasticity(membrane_material));
        const auto convex = hessian(triangle, random.matrix<TrianglePositions>(1), true);
        const VectorXd eigenvalues = test::eigenvalues(convex);
        EXPECT_GT(eigenvalues[0], -1e-12 * eigenvalues[8]);
        const TrianglePositions stretched = 1.2 * rest;
        EXPECT_LT((hessian(triangle, stretched, true) - hessian(triangle, stretched, false)).norm(),
                  1e-12 * convex.norm());
    }
}

TEST(Membrane, HasNoEnergyAtRestNorUnderRigidMotion) {
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const TrianglePositions rest = random.matrix<TrianglePositions>(1);
        const MembraneTriangle triangle = membrane_triangle(rest, membrane_elasticity(membrane_material));
        const TrianglePositions moved = (random.rotation() * rest).colwise() + random.matrix<Vector3d>(5);
        EXPECT_LT(green_strain(triangle, moved).norm(), 1e-12 / triangle.area);
    }
}

TEST(Membrane, HasNoNetForceOrTorqueOnAnyDeformation) {
    Random random(5);
    for (int i = 0; i < 100; ++i) {
        const MembraneTriangle triangle = random_triangle(random);
        const TrianglePositions x = random.matrix<TrianglePositions>(2), force = gradient(triangle, x);
        Vector3d torque = Vector3d::Zero();
        for (int v = 0; v < 3; ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
        EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
        EXPECT_LT(torque.norm(), 1e-12 * force.norm() * x.norm());
    }
}

// Uniaxial stretch of a strip that is free to contract must give Young's modulus and Poisson's ratio.
TEST(Membrane, UniaxialStressFollowsYoungAndPoisson) {
    TrianglePositions rest;
    rest << 0, 1, 0, 0, 0, 1, 0, 0, 0;
    const MembraneTriangle triangle = membrane_triangle(rest, membrane_elasticity(membrane_material));
    const double strain = 1e-6;
    TrianglePositions x = rest;
    x.row(0) *= 1 + strain;
    x.row(1) *= 1 - membrane_material.poisson * strain;
    const double expected =
        0.5 * membrane_material.young * membrane_material.thickness * strain * strain * triangle.area;
    EXPECT_NEAR(value(triangle, x), expected, 1e-5 * expected);
}

// The material axis belongs to the sheet: which corner a file names first must not matter.
TEST(Membrane, OrthotropicEnergyDoesNotDependOnTheOrderOfTheCornersOrThePlace) {
    Random random(6);
    for (int i = 0; i < 100; ++i) {
        const TrianglePositions rest = random.matrix<TrianglePositions>(1),
                                x = random.matrix<TrianglePositions>(1);
        const Vector3d axis = rest * Vector3d(-1.3, 0.4, 0.9);
        const Matrix3d turn = random.rotation();
        TrianglePositions rest_turned = turn * rest, x_next = x;
        for (int v = 0; v < 3; ++v) {
            rest_turned.col(v) = turn * rest.col((v + 1) % 3);
            x_next.col(v) = x.col((v + 1) % 3);
        }
        const double expected = value(cloth_triangle(rest, axis), x);
        EXPECT_NEAR(value(cloth_triangle(rest_turned, turn * axis), x_next), expected, 1e-10 * expected);
        EXPECT_NEAR(value(cloth_triangle(rest, -axis), x), expected, 1e-10 * expected);
    }
}

// Stretched along an axis and free to contract, cloth must have the modulus of that axis: 7.5 times less
// along the second axis than along the first.
TEST(Membrane, UniaxialStressFollowsTheModulusOfItsDirection) {
    TrianglePositions rest;
    rest << 0, 1, 0, 0, 0, 1, 0, 0, 0;
    const double strain = 1e-6;
    for (const bool along : {true, false}) {
        const MembraneTriangle triangle = cloth_triangle(rest, along ? Vector3d::UnitX() : Vector3d::UnitY());
        const double young = along ? cloth.young : *cloth.young1;
        TrianglePositions x = rest;
        x.row(0) *= 1 + strain;
        x.row(1) *= 1 - cloth.poisson * young / cloth.young * strain;
        const double expected = 0.5 * young * cloth.thickness * strain * strain * triangle.area;
        EXPECT_NEAR(value(triangle, x), expected, 1e-5 * expected);
    }
}

}  // namespace
}  // namespace sherd
