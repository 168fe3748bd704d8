// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/coupled_bending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

// With a wrong sign or factor in the forces, or a pair of vertices missing in the pattern, sheets would move
// wrongly or the solver would not converge.
TEST(CoupledBending, DerivativesAreThoseOfTheValue) {
    Shell flat_sheet = test::flat_patch(), shell = test::curved_patch();
    for (Shell* sheet : {&flat_sheet, &shell}) {
        const CoupledBending free(*sheet, {}), held(*sheet, test::patch_mirrors(*sheet));
        const Positions x = test::shaken(*sheet, 0.03, 1);
        test::expect_derivatives(free, x, 1e-5, 1e-7);
        test::expect_derivatives(held, x, 1e-5, 1e-7);
    }
}

// With wrong derivatives the solver would not converge where faces yield. All faces here are far beyond the
// yield stress: near it the second derivative changes too fast for difference quotients; YieldingSection
// tests that range.
TEST(CoupledBending, DerivativesAreThoseOfTheValueWhereFacesYield) {
    Shell shell = test::curved_patch();
    shell.face_sheet.assign(shell.triangles.size(), 0);
    const Positions x = test::shaken(shell, 0.03, 1);
    const CoupledBending elastic(shell, test::patch_mirrors(shell));
    const Eigen::Matrix3Xd bent = elastic.curvatures(x);
    double moment = 0;  // N, mean over the faces
    for (Index f = 0; f < static_cast<Index>(shell.triangles.size()); ++f)
        moment += (elastic.rigidity(f) * bent.col(f)).norm() / shell.triangles[f].membrane.area /
                  static_cast<double>(shell.triangles.size());
    const double yield = 0.01 * 6 * moment / std::pow(shell.thickness[0], 2);
    CoupledBending bending(shell, test::patch_mirrors(shell));
    bending.set_yield({yield});
    EXPECT_GT(bending.dissipated_by_yielding(x), 0.5 * bending.value(x));
    EXPECT_GT(bending.plastic_curvatures(x).colwise().norm().minCoeff(), 0);
    test::expect_derivatives(bending, x, 1e-5, 1e-5);
    bending.store_plastic_curvature(x);
    EXPECT_EQ(bending.dissipated_by_yielding(x), 0);
    EXPECT_GT(bending.value(x), 0);
    EXPECT_LT((bending.curvatures(x) + bending.plastic_curvatures(x) - bent).norm(), 1e-9 * bent.norm());
}

// Sheets must neither move nor spin by their own bending, and must keep their rest shape.
TEST(CoupledBending, RestIsEquilibriumAndRigidMotionCostsNothing) {
    Shell shell = test::curved_patch();
    const CoupledBending bending(shell, {});
    test::Random random(3);
    const Positions moved = (random.rotation() * shell.rest).colwise() + random.matrix<Vector3d>(2);
    EXPECT_LT(bending.value(moved), 1e-24);
    EXPECT_LT(test::gradient_of(bending, moved).norm(), 1e-10);
    EXPECT_LT(test::gradient_of(CoupledBending(shell, test::patch_mirrors(shell)), shell.rest).norm(), 1e-10);

    const Positions x = test::shaken(shell, 0.05, 2), force = test::gradient_of(bending, x);
    Vector3d torque = Vector3d::Zero();
    for (Index v = 0; v < x.cols(); ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
    EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
    EXPECT_LT(torque.norm(), 1e-12 * force.norm());
    const Positions x_moved = (random.rotation() * x).colwise() + random.matrix<Vector3d>(2);
    EXPECT_NEAR(bending.value(x_moved), bending.value(x), 1e-11 * bending.value(x));
}

// Newton's method uses the convex Hessian where the exact one is indefinite.
TEST(CoupledBending, ConvexHessianIsSemidefiniteAndExactAtRest) {
    Shell shell = test::curved_patch();
    const CoupledBending bending(shell, test::patch_mirrors(shell));
    const Eigen::MatrixXd convex = test::hessian_of(bending, test::shaken(shell, 0.05, 3), Curvature::convex);
    const VectorXd eigenvalues = test::eigenvalues(convex);
    EXPECT_GT(eigenvalues[0], -1e-10 * eigenvalues.tail<1>()[0]);
    const Eigen::MatrixXd exact = test::hessian_of(bending, shell.rest, Curvature::exact);
    EXPECT_LT((exact - test::hessian_of(bending, shell.rest, Curvature::convex)).norm(), 1e-9 * exact.norm());
}

// Mechanisms would let a sheet crumple without energy: only rigid motions, and motions of a flat sheet in
// its plane, may cost no bending energy.
TEST(CoupledBending, FlatSheetHasNoModesWithoutEnergyButItsPlanes) {
    const Shell shell = test::flat_patch();
    const CoupledBending bending(shell, {});
    const Eigen::MatrixXd all = test::hessian_of(bending, shell.rest, Curvature::exact);
    const Eigen::Index count = shell.rest.cols();
    Eigen::MatrixXd out_of_plane(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j) out_of_plane(i, j) = all(3 * i + 2, 3 * j + 2);
    const VectorXd eigenvalues = test::eigenvalues(out_of_plane);
    EXPECT_LT(eigenvalues[2], 1e-9 * eigenvalues[count - 1]);  // a translation and two rotations
    EXPECT_GT(eigenvalues[3], 1e-5 * eigenvalues[count - 1]);
}

/// Largest square of a frequency of the sheet's bending out of its plane z = 0, 1/s^2.
double highest_square(const Shell& shell) {
    const Eigen::MatrixXd all = test::hessian_of(CoupledBending(shell, {}), shell.rest, Curvature::exact);
    const Eigen::Index count = shell.rest.cols();
    const VectorXd root = shell.mass.cwiseSqrt();
    Eigen::MatrixXd scaled(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j)
            scaled(i, j) = all(3 * i + 2, 3 * j + 2) / (root[i] * root[j]);
    return test::eigenvalues(scaled).maxCoeff();
}

/// Strips of triangles between two rows of vertices at uneven distances; none has an angle below 28 degrees.
struct Strip {
    Positions rest{3, 6};
    std::vector<std::array<Index, 3>> triangles{{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};

    explicit Strip(test::Random& random) {
        for (Index v = 0; v < 6; ++v)
            rest.col(v) =
                Vector3d(0.5 * v + random.uniform(-0.3, 0.3), 0.87 * (v % 2) + random.uniform(-0.3, 0.3), 0);
    }
    bool is_regular() const {
        return std::ranges::all_of(triangles, [this](const std::array<Index, 3>& corners) {
            const Matrix3d at = columns(rest, corners);
            double cosine = 0;
            for (int i = 0; i < 3; ++i)
                cosine = std::max(cosine, (at.col((i + 1) % 3) - at.col(i))
                                              .normalized()
                                              .dot((at.col((i + 2) % 3) - at.col(i)).normalized()));
            return cosine < std::cos(28 * std::numbers::pi / 180);
        });
    }
};

// Cracks leave narrow pieces and ears. If the few hinges there determined the tangents badly, these would be
// far stiffer than each two of their triangles, explicit substeps would be several times as short, and
// stresses wrong.
TEST(CoupledBending, StripIsHardlyStifferThanItsTriangles) {
    test::Random random(5);
    const Material material{.density = 1, .thickness = 0.1, .young = 1, .poisson = 0.3};
    int regular = 0;
    while (regular < 300) {
        const Strip strip(random);
        if (!strip.is_regular()) continue;
        ++regular;
        double of_pairs = 0;
        for (const Index first : {0, 1, 2}) {
            std::vector<std::array<Index, 3>> pair{strip.triangles[first], strip.triangles[first + 1]};
            for (auto& corners : pair)
                for (Index& corner : corners) corner -= first;
            of_pairs = std::max(
                of_pairs, highest_square(test::small_sheet(strip.rest.middleCols(first, 4), pair, material)));
        }
        EXPECT_LT(highest_square(test::small_sheet(strip.rest, strip.triangles, material)), 10 * of_pairs);
    }
}

/// Height of a quadratic surface.
double quadratic(double x, double y) {
    return 0.5 * x * x + 0.7 * x * y - 0.3 * y * y;
}

// Without this property, which single hinges lack, bending would not converge as a mesh is refined.
TEST(CoupledBending, QuadraticSurfaceHasItsCurvatureInEveryFaceButAtFreeEdges) {
    const Shell shell = test::flat_patch();
    const double amplitude = 1e-6;
    Positions x = shell.rest;
    for (Index v = 0; v < x.cols(); ++v) x(2, v) = amplitude * quadratic(x(0, v), x(1, v));
    const Eigen::Matrix3Xd curvatures = CoupledBending(shell, {}).curvatures(x);
    std::vector<int> free_sides(shell.triangles.size(), 3);
    for (const auto& sides : sides_of_hinges(shell))
        for (const auto& [triangle, corner] : sides) --free_sides[triangle];
    int inner = 0;
    for (std::size_t f = 0; f < free_sides.size(); ++f) {
        if (free_sides[f] > 0) continue;
        const auto& vertices = shell.triangles[f].vertices;
        const Vector3d first = shell.rest.col(vertices[1]) - shell.rest.col(vertices[0]);
        const Vector3d expected = turned_tensor({1, -0.6, 0.7}, -std::atan2(first.y(), first.x()));
        const Vector3d found = curvatures.col(static_cast<Eigen::Index>(f)) / amplitude;
        EXPECT_NEAR(found[0], expected[0], 1e-6);
        EXPECT_NEAR(found[1], expected[1], 1e-6);
        EXPECT_NEAR(found[2], 2 * expected[2], 1e-6);
        ++inner;
    }
    EXPECT_GT(inner, 20);
}

// At a symmetry plane and at a clamp, the curvature of a face must include the mirror image of the surface.
TEST(CoupledBending, SurfaceHasItsCurvatureBesideMirrors) {
    Shell shell = test::flat_patch();
    const double amplitude = 1e-6;
    Positions x = shell.rest;  // slope zero across both mirrors
    for (Index v = 0; v < x.cols(); ++v) x(2, v) = amplitude * (0.5 * x(0, v) * x(0, v) - x(1, v) * x(1, v));
    const Eigen::Matrix3Xd curvatures = CoupledBending(shell, test::patch_mirrors(shell)).curvatures(x);
    const std::array<Index, 3>& corner = shell.triangles[1].vertices;  // vertex 0 is on both mirrors
    EXPECT_EQ(*std::ranges::min_element(corner), 0);
    EXPECT_NEAR((curvatures(0, 1) + curvatures(1, 1)) / amplitude, -1, 1e-6);
}

// Damping measures curvatures from another shape than the rest shape.
TEST(CoupledBending, StartsFromAnyShape) {
    const Shell shell = test::curved_patch();
    CoupledBending bending(shell, {});
    const Positions from = test::shaken(shell, 0.05, 5), x = test::shaken(shell, 0.05, 6);
    const VectorXd between = bending.changes(x) - bending.changes(from);
    bending.start_from(from, 3);
    EXPECT_LT(bending.value(from), 1e-24);
    EXPECT_LT((bending.changes(x) - between).norm(), 1e-12);
    test::expect_derivatives(bending, x, 1e-5, 1e-7);
}

}  // namespace
}  // namespace sherd
