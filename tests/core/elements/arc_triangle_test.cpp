// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/arc_triangle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/material/material.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using ArcUnknowns = Eigen::Matrix<double, 12, 1>;

/// A random triangle of an orthotropic sheet whose sides are curved in the shape without energy.
ArcTriangle random_arcs(test::Random& random) {
    const TrianglePositions rest = random.matrix<TrianglePositions>(1);
    const Matrix3d elasticity = membrane_elasticity({1000, 0.01, 3e5, 0.3, 4e4, 2e4}, 0.4);
    const Vector3d squares = side_squares(rest);
    return {membrane_triangle(rest, elasticity), squares,
            arc_sagittas(squares, rest, random.matrix<Vector3d>(1))};
}

TrianglePositions corners_of(const ArcUnknowns& all) {
    return all.head<9>().reshaped(3, 3);
}

ArcUnknowns slope_of_arcs(const ArcTriangle& triangle, const ArcUnknowns& at) {
    const ArcGradient slope = gradient(triangle, corners_of(at), at.tail<3>());
    ArcUnknowns all;
    all << slope.by_positions.reshaped(), slope.by_curvature;
    return all;
}

// A wrong term in the forces or in the Hessian makes sheets move wrongly or the solver diverge.
TEST(ArcTriangle, DerivativesAreThoseOfTheValue) {
    test::Random random(1);
    constexpr double step = 1e-5;
    for (int i = 0; i < 100; ++i) {
        const ArcTriangle triangle = random_arcs(random);
        const ArcUnknowns at = random.matrix<ArcUnknowns>(1);
        const ArcUnknowns slope = slope_of_arcs(triangle, at);
        const auto exact = hessian(triangle, corners_of(at), at.tail<3>(), false);
        for (int c = 0; c < 12; ++c) {
            const ArcUnknowns ahead = at + step * ArcUnknowns::Unit(c),
                              behind = at - step * ArcUnknowns::Unit(c);
            const double rise = value(triangle, corners_of(ahead), ahead.tail<3>()) -
                                value(triangle, corners_of(behind), behind.tail<3>());
            EXPECT_NEAR(slope[c], rise / (2 * step), 1e-7 * slope.norm());
            const ArcUnknowns change = slope_of_arcs(triangle, ahead) - slope_of_arcs(triangle, behind);
            EXPECT_LT((exact.col(c) - change / (2 * step)).norm(), 1e-7 * exact.norm());
        }
    }
}

// Without curvature the triangle must equal the constant-strain triangle, with which everything else was
// verified.
TEST(ArcTriangle, WithoutCurvatureIsTheConstantStrainTriangle) {
    test::Random random(2);
    const Vector3d none = Vector3d::Zero();
    for (int i = 0; i < 100; ++i) {
        ArcTriangle triangle = random_arcs(random);
        triangle.start = none;
        const MembraneTriangle& flat = triangle.membrane;
        const TrianglePositions x = random.matrix<TrianglePositions>(1);
        EXPECT_NEAR(value(triangle, x, none), value(flat, x), 1e-12 * value(flat, x));
        const TrianglePositions slope = gradient(flat, x);
        EXPECT_LT((gradient(triangle, x, none).by_positions - slope).norm(), 1e-11 * slope.norm());
        EXPECT_EQ(gradient(triangle, x, none).by_curvature, none);
        for (const bool convex : {false, true}) {
            const Eigen::Matrix<double, 9, 9> same = hessian(flat, x, convex);
            const auto all = hessian(triangle, x, none, convex);
            EXPECT_LT((all.topLeftCorner<9, 9>() - same).norm(), 1e-10 * same.norm());
            EXPECT_EQ((all.topRightCorner<9, 3>().norm()), 0);
        }
    }
}

// Newton's method uses the convex Hessian where a sheet buckles.
TEST(ArcTriangle, ConvexHessianIsSemidefiniteAndExactAtTheStart) {
    test::Random random(3);
    for (int i = 0; i < 200; ++i) {
        ArcTriangle triangle = random_arcs(random);
        const ArcUnknowns at = random.matrix<ArcUnknowns>(1);
        const VectorXd convex = test::eigenvalues(hessian(triangle, corners_of(at), at.tail<3>(), true));
        EXPECT_GT(convex[0], -1e-12 * convex[11]);
    }
    const TrianglePositions rest = random.matrix<TrianglePositions>(1);
    const Vector3d curvature(0.3, -0.2, 0.5), squares = side_squares(rest);
    const ArcTriangle triangle{membrane_triangle(rest, membrane_elasticity({1000, 0.01, 3e5, 0.3})), squares,
                               arc_sagittas(squares, rest, curvature)};
    EXPECT_LT(value(triangle, rest, curvature), 1e-24);
    const auto exact = hessian(triangle, rest, curvature, false);
    EXPECT_LT((exact - hessian(triangle, rest, curvature, true)).norm(), 1e-12 * exact.norm());
}

// When a triangle is rolled onto a cylinder, its arcs are as long as the sides of the flat triangle: they
// must hardly be strained, while the chords are.
TEST(ArcTriangle, RolledTriangleHasAlmostNoStrain) {
    constexpr double radius = 2;
    TrianglePositions rest, x;
    rest << 0, 0.5, 0.2, 0, 0.1, 0.4, 0, 0, 0;
    Vector3d curvature;
    for (int c = 0; c < 3; ++c) {
        x.col(c) << radius * std::sin(rest(0, c) / radius), rest(1, c),
            radius * (1 - std::cos(rest(0, c) / radius));
        const Vector3d along = rest.col((c + 2) % 3) - rest.col((c + 1) % 3);
        curvature[c] = along.x() * along.x() / along.squaredNorm() / radius;
    }
    const ArcTriangle triangle{membrane_triangle(rest, Matrix3d::Identity()), side_squares(rest),
                               Vector3d::Zero()};
    const double chords = green_strain(triangle.membrane, x).norm();
    EXPECT_GT(chords, 2e-3);
    EXPECT_LT(green_strain(triangle, x, curvature).norm(), 0.01 * chords);
}

}  // namespace
}  // namespace sherd
