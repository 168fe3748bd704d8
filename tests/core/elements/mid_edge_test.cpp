// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/mid_edge.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

TrianglePositions triangle_anywhere(test::Random& random) {
    TrianglePositions x;
    x << 0, random.uniform(0.5, 2), random.uniform(-0.5, 2.5), 0, 0, random.uniform(0.1, 2), 0, 0, 0;
    x = (random.rotation() * x).eval();
    return x.colwise() + random.matrix<Vector3d>(3);
}

/// Height at p of the quadratic surface whose curvature has the components (00, 11, 2 * 01).
double height(const Vector3d& curvature, const Vector2d& p) {
    return 0.5 * (curvature[0] * p.x() * p.x() + curvature[1] * p.y() * p.y() + curvature[2] * p.x() * p.y());
}

/// Slope at p of this surface.
Vector2d slope(const Vector3d& curvature, const Vector2d& p) {
    return {curvature[0] * p.x() + 0.5 * curvature[2] * p.y(),
            curvature[1] * p.y() + 0.5 * curvature[2] * p.x()};
}

// A wrong angle would bend faces wrongly: tangent_angle() must give the angle, at the middle of a side, from
// the facet through three points of a quadratic surface to the surface's tangent plane.
TEST(MidEdge, TangentAngleIsThatOfAQuadraticSurface) {
    test::Random random(1);
    for (int i = 0; i < 200; ++i) {
        const PlaneTriangle triangle = plane_triangle(triangle_anywhere(random));
        const Vector3d curvature = random.matrix<Vector3d>(1);
        // facet: height = g . p + constant
        Matrix3d points;
        Vector3d heights;
        for (int c = 0; c < 3; ++c) {
            points.row(c) << triangle.corners.col(c).transpose(), 1;
            heights[c] = height(curvature, triangle.corners.col(c));
        }
        const Vector2d facet = points.inverse().topRows<2>() * heights;
        for (int side = 0; side < 3; ++side) {
            const Vector2d from = triangle.corners.col((side + 1) % 3),
                           to = triangle.corners.col((side + 2) % 3);
            const Vector2d along = (to - from).normalized(), outward(along.y(), -along.x());
            const double angle = outward.dot(slope(curvature, 0.5 * (from + to)) - facet);
            EXPECT_NEAR(tangent_angle(triangle, side).dot(curvature), angle, 1e-9);
        }
    }
}

// A sheet of constant curvature has it in all faces only if the angles that a curvature makes at the sides
// give the same curvature back.
TEST(MidEdge, AnglesAtTheSidesGiveTheCurvatureBack) {
    test::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const PlaneTriangle triangle = plane_triangle(triangle_anywhere(random));
        const Vector3d curvature = random.matrix<Vector3d>(1);
        Vector3d sum = Vector3d::Zero();
        for (int side = 0; side < 3; ++side)
            sum += tangent_angle(triangle, side).dot(curvature) * curvature_of_tangent(triangle, side);
        EXPECT_LT((sum - curvature).norm(), 1e-9);
    }
}

// In a left-handed frame, or one that is turned the wrong way, the axes of membrane and plate would be
// turned.
TEST(MidEdge, TriangleIsLaidIntoTheFrameOfItsMembrane) {
    test::Random random(3);
    for (int i = 0; i < 50; ++i) {
        const TrianglePositions rest = triangle_anywhere(random);
        const PlaneTriangle plane = plane_triangle(rest);
        const MembraneTriangle membrane = membrane_triangle(rest, Matrix3d::Identity());
        // The derivative of the coordinates themselves is the identity.
        EXPECT_LT((plane.corners * membrane.derivatives - Eigen::Matrix2d::Identity()).norm(), 1e-12);
        EXPECT_NEAR(plane.area, membrane.area, 1e-12);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(height_over_side(plane, c) * membrane.derivatives.row(c).norm(), 1, 1e-12);
    }
}

TEST(MidEdge, TurnedTensorHasTheSameValueAlongTheSameDirection) {
    const Vector3d tensor(2, -1, 0.7);
    const double turn = 0.6;
    const Vector3d turned = turned_tensor(tensor, turn);
    for (const double angle : {0.0, 0.4, 2.0}) {
        const auto along = [](const Vector3d& t, double a) {
            return t[0] * std::cos(a) * std::cos(a) + t[1] * std::sin(a) * std::sin(a) +
                   t[2] * std::sin(2 * a);
        };
        EXPECT_NEAR(along(tensor, angle), along(turned, angle + turn), 1e-14);
    }
}

}  // namespace
}  // namespace sherd
