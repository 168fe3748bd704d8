// SPDX-License-Identifier: GPL-3.0-or-later
// A wrong distance lets sheets into an obstacle; wrong derivatives push sheets the wrong way, or keep
// Newton's method from converging.
#include "core/contact/geometry/basic_shapes.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {
namespace {

void expect_normal_and_curvature(const Shape& shape, const Vector3d& at) {
    const auto value = [&](const Vector3d& x) { return shape.distance(x).distance; };
    const auto gradient = [&](const Vector3d& x) { return shape.distance(x).gradient; };
    const SurfaceDistance exact = shape.distance(at);
    EXPECT_NEAR(exact.gradient.norm(), 1, 1e-14);
    EXPECT_LT((exact.gradient - difference_gradient(value, at, 1e-5)).norm(), 1e-8) << at.transpose();
    const Matrix3d numeric = difference_hessian(gradient, at, 1e-5);
    EXPECT_LT((exact.hessian - numeric).norm(), 1e-7 * (1 + numeric.norm())) << at.transpose();
}

const Vector3d axis = Vector3d(1, 2, -0.5).normalized();

// Points are inside and outside, without the few near a crease of the distance, where its gradient jumps.
TEST(Solids, GradientAndHessianAreThoseOfTheDistance) {
    Random random(3);
    const std::vector<std::shared_ptr<const Shape>> shapes{
        std::make_shared<PlaneShape>(Vector3d(0.1, 0, 0), axis),
        std::make_shared<SphereShape>(Vector3d(0.1, 0.2, 0), 0.7),
        std::make_shared<BoxShape>(Vector3d(0.1, 0, 0), Vector3d(0.3, 0.5, 0.4)),
        std::make_shared<CylinderShape>(Vector3d(0.1, 0, 0), axis, 0.5, 0.8)};
    for (const auto& shape : shapes)
        for (int i = 0; i < 200; ++i) {
            const Vector3d at = random.matrix<Vector3d>(1);
            Vector3d spread = Vector3d::Zero();
            for (int k = 0; k < 6; ++k) {
                Vector3d beside = at;
                beside[k / 2] += k % 2 ? 1e-3 : -1e-3;
                spread[k / 2] = std::max(
                    spread[k / 2], (shape->distance(beside).gradient - shape->distance(at).gradient).norm());
            }
            if (spread.maxCoeff() < 0.1) expect_normal_and_curvature(*shape, at);
        }
}

// Outside two or three of a box's faces at once, the surfaces of equal distance are round about its edge or
// corner.
TEST(Solids, EdgesAndCornersOfABoxAreRoundFromOutside) {
    const BoxShape box(Vector3d(1, 0, 0), Vector3d(0.5, 0.2, 0.3));
    EXPECT_DOUBLE_EQ(box.distance(Vector3d(1.1, 0.25, 0)).distance, 0.05);
    EXPECT_DOUBLE_EQ(box.distance(Vector3d(0.2, -0.6, 0)).distance, 0.5);
    EXPECT_DOUBLE_EQ(box.distance(Vector3d(1.51, -0.22, 0.32)).distance, 0.03);
    EXPECT_DOUBLE_EQ(box.distance(Vector3d(1, 0.15, 0)).distance, -0.05);
    for (const Vector3d& at : {Vector3d(1.1, 0.25, 0), Vector3d(0.2, -0.6, 0), Vector3d(1.51, -0.22, 0.32),
                               Vector3d(1, 0.15, 0), Vector3d(1.502, 0.1, 0.303)})
        expect_normal_and_curvature(box, at);
}

TEST(Solids, ACylinderHasASideTwoEndsAndRoundEdges) {
    const CylinderShape cylinder(Vector3d(0, 0, 1), axis, 0.5, 2);
    const Vector3d out = axis.unitOrthogonal(), middle(0, 0, 1);
    const auto distance = [&](double along, double away) {
        const Vector3d at = middle + along * axis + away * out;
        expect_normal_and_curvature(cylinder, at);
        return cylinder.distance(at).distance;
    };
    EXPECT_NEAR(distance(0.2, 0.6), 0.1, 1e-15);
    EXPECT_NEAR(distance(-1.2, 0.3), 0.2, 1e-15);
    EXPECT_NEAR(distance(1.3, 0.9), 0.5, 1e-15);
    EXPECT_NEAR(distance(-0.9, 0.2), -0.1, 1e-15);
    EXPECT_NEAR(distance(0.1, 0.3), -0.2, 1e-15);
    EXPECT_NEAR(cylinder.distance(middle).distance, -0.5, 1e-15) << "on the axis";
    EXPECT_NEAR(cylinder.distance(middle).gradient.norm(), 1, 1e-15);
}

// Points outside the bounds are skipped: too small bounds would let sheets into the solid.
TEST(Solids, BoundsHoldTheSolid) {
    Random random(5);
    const CylinderShape cylinder(Vector3d(0, 0, 1), axis, 0.5, 0.3);
    const SphereShape sphere(Vector3d(0, 0.5, 0.5), 0.4);
    const BoxShape box(Vector3d(0, 0.5, 0.5), Vector3d(0.1, 0.4, 0.2));
    for (int i = 0; i < 5000; ++i) {
        const Vector3d at = Vector3d(0, 0.5, 0.8) + random.matrix<Vector3d>(0.8);
        for (const Shape* shape : {static_cast<const Shape*>(&cylinder), static_cast<const Shape*>(&sphere),
                                   static_cast<const Shape*>(&box)})
            if (shape->distance(at).distance <= 0) {
                EXPECT_TRUE(shape->bounds().contains(at)) << at.transpose();
            }
    }
    EXPECT_NEAR(cylinder.bounds().diagonal().x(),
                0.3 * axis.x() + 2 * 0.5 * std::sqrt(1 - axis.x() * axis.x()), 1e-12);
}

}  // namespace
}  // namespace sherd::test
