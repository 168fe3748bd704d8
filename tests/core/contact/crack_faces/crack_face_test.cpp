// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/crack_faces/crack_face.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/random_shapes.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

/// Random triangles, vertices 1 to 3, that are not needles, each with a random vertex 0.
std::vector<PairPositions> crack_faces() {
    test::Random random(11);
    std::vector<PairPositions> shapes;
    while (shapes.size() < 200) {
        const PairPositions x = random.matrix<PairPositions>(1);
        const Vector3d edge = x.col(2) - x.col(1), side = x.col(3) - x.col(1);
        if (edge.cross(side).norm() > 0.3 * edge.squaredNorm() && edge.norm() > 0.3) shapes.push_back(x);
    }
    return shapes;
}

// With a wrong sign of the opening, crack faces would be pulled together. Vertex 0 is at a known distance
// before a crack face (lip), the edge from vertex 1 to 2; its height above the triangle's plane must not
// count.
TEST(CrackFace, OpeningIsTheDistanceInFrontOfTheCrackFaceInItsPlane) {
    PairPositions x;
    x << 0.3, 0, 1, 0.4,  //
        -0.2, 0, 0, 0.7,  //
        0.5, 0, 0, 0;
    EXPECT_DOUBLE_EQ(crack_face_opening(x), 0.2);
    x(1, 0) = 0.1;
    EXPECT_DOUBLE_EQ(crack_face_opening(x), -0.1);
}

TEST(CrackFace, GradientAndHessianAreDerivativesWithoutForceAndTorque) {
    for (const PairPositions& x : crack_faces()) {
        const PairPositions gradient = crack_face_opening_gradient(x);
        const PairHessian hessian = crack_face_opening_hessian(x);
        EXPECT_LT((test::difference_gradient(crack_face_opening, x, 1e-4) - gradient).norm(),
                  1e-8 * gradient.norm());
        EXPECT_LT((test::difference_hessian(crack_face_opening_gradient, x, 1e-4) - hessian).norm(),
                  1e-8 * (1 + hessian.norm()));
        EXPECT_EQ(hessian, PairHessian(hessian.transpose()));
        Vector3d torque = Vector3d::Zero();
        for (int i = 0; i < 4; ++i) torque += Vector3d(x.col(i)).cross(Vector3d(gradient.col(i)));
        EXPECT_LT(gradient.rowwise().sum().norm(), 1e-13 * gradient.norm());
        EXPECT_LT(torque.norm(), 1e-13 * gradient.norm());
    }
}

// Overlapping crack faces must push, and open ones must not stick; the convex Hessian, which the solver uses
// where the exact one is indefinite, must be semidefinite.
TEST(CrackFace, OverlapPushesAndOpenCrackFacesAreFree) {
    const std::vector<CrackFaceStencil> stencils{{{0, 1, 2, 3}, 5e3}};
    const CrackFaceContact contact(stencils);
    for (const PairPositions& x : crack_faces()) {
        const double opening = crack_face_opening(x);
        const Positions positions = x;
        EXPECT_EQ(contact.largest_overlap(positions), std::max(0.0, -opening));
        EXPECT_DOUBLE_EQ(contact.value(positions), opening < 0 ? 0.5 * 5e3 * opening * opening : 0);
        if (opening > -1e-3) continue;  // no differences across the kink
        test::expect_derivatives(contact, positions, 1e-6, 1e-7);
        BlockMatrix convex(4, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}, std::vector<char>(4, 0));
        contact.add_hessian(positions, Curvature::convex, convex);
        const Eigen::MatrixXd matrix = test::dense(convex);
        EXPECT_GE(test::eigenvalues(matrix)[0], -1e-12 * matrix.norm());
    }
}

}  // namespace
}  // namespace sherd
