// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/coupled_bending.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/support/small_sheet.h"

namespace sherd {
namespace {

constexpr int across = 5, along = 7;  // vertices
const Material material{1000, 0.05, 12 / (0.05 * 0.05 * 0.05), 0.3};

/// A rectangle of 1.2 by 0.8 with unequal triangles; each vertex is then put at place(x, y).
template <class Place>
Shell patch(Place place) {
    Positions rest(3, along * across);
    std::vector<std::array<Index, 3>> triangles;
    test::Random random(4);
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j) {
            const bool inner = i > 0 && j > 0 && i + 1 < along && j + 1 < across;
            const double jitter = inner ? 0.05 : 0;
            const double x = 0.2 * i + random.uniform(-jitter, jitter),
                         y = 0.2 * j + random.uniform(-jitter, jitter);
            rest.col(across * i + j) = place(x, y);
            if (i == 0 || j == 0) continue;
            const Index a = across * (i - 1) + j - 1, b = a + across, c = b + 1, d = a + 1;
            if ((i + j) % 3 == 0)
                triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
            else
                triangles.insert(triangles.end(), {{b, c, d}, {a, b, d}});
        }
    return test::small_sheet(rest, triangles, material);
}

Shell flat() {
    return patch([](double x, double y) { return Vector3d(x, y, 0); });
}

/// A saddle-like shell, with angles at rest up to half a radian.
Shell curved() {
    return patch(
        [](double x, double y) { return Vector3d(x, y, 0.2 * std::sin(4 * x) + 0.3 * y * y - 0.2 * x * y); });
}

Positions shaken(const Shell& shell, double amplitude, unsigned seed) {
    test::Random random(seed);
    Positions x = shell.rest;
    for (double& coordinate : x.reshaped()) coordinate += random.uniform(-amplitude, amplitude);
    return x;
}

/// Clamps the side x = 0, and puts a symmetry plane at y = 0.
std::vector<MirrorHinge> mirrors(Shell& shell) {
    std::vector<char> wall(shell.rest.cols()), plane(shell.rest.cols());
    for (Index v = 0; v < static_cast<Index>(wall.size()); ++v) {
        wall[v] = v < across;
        plane[v] = v % across == 0;
    }
    std::vector<MirrorHinge> hinges;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, wall))
        hinges.push_back(clamp_hinge(shell, side, 1));
    for (const TriangleEdge& side : boundary_triangle_edges(shell, plane))
        hinges.push_back(symmetry_hinge(shell, side, Vector3d::UnitY(), 1));
    EXPECT_EQ(hinges.size(), static_cast<std::size_t>(along + across - 2));
    return hinges;
}

Positions gradient(const Energy& energy, const Positions& x) {
    Positions sum = Positions::Zero(3, x.cols());
    energy.add_gradient(x, sum);
    return sum;
}

Eigen::MatrixXd hessian(const Energy& energy, const Positions& x, Curvature curvature) {
    std::vector<std::pair<Index, Index>> pairs;
    energy.add_pattern(pairs);
    BlockMatrix matrix(static_cast<Index>(x.cols()), pairs, std::vector<char>(x.cols(), 0));
    energy.add_hessian(x, curvature, matrix);
    return test::dense(matrix);
}

// A wrong sign or factor in the forces, or a pair of vertices that the pattern misses, would show here.
TEST(CoupledBending, DerivativesAreThoseOfTheValue) {
    Shell flat_sheet = flat(), shell = curved();
    for (Shell* sheet : {&flat_sheet, &shell}) {
        const CoupledBending free(*sheet, {}), held(*sheet, mirrors(*sheet));
        const Positions x = shaken(*sheet, 0.03, 1);
        test::expect_derivatives(free, x, 1e-5, 1e-7);
        test::expect_derivatives(held, x, 1e-5, 1e-7);
    }
}

// Sheets must neither move nor spin by their own bending, and must stay as they are made.
TEST(CoupledBending, RestIsEquilibriumAndRigidMotionCostsNothing) {
    Shell shell = curved();
    const CoupledBending bending(shell, {});
    test::Random random(3);
    const Positions moved = (random.rotation() * shell.rest).colwise() + random.matrix<Vector3d>(2);
    EXPECT_LT(bending.value(moved), 1e-24);
    EXPECT_LT(gradient(bending, moved).norm(), 1e-10);
    EXPECT_LT(gradient(CoupledBending(shell, mirrors(shell)), shell.rest).norm(), 1e-10);

    const Positions x = shaken(shell, 0.05, 2), force = gradient(bending, x);
    Vector3d torque = Vector3d::Zero();
    for (Index v = 0; v < x.cols(); ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
    EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
    EXPECT_LT(torque.norm(), 1e-12 * force.norm());
    const Positions x_moved = (random.rotation() * x).colwise() + random.matrix<Vector3d>(2);
    EXPECT_NEAR(bending.value(x_moved), bending.value(x), 1e-11 * bending.value(x));
}

// Newton's method goes on with it where the Hessian itself is indefinite.
TEST(CoupledBending, ConvexHessianIsSemidefiniteAndExactAtRest) {
    Shell shell = curved();
    const CoupledBending bending(shell, mirrors(shell));
    const Eigen::MatrixXd convex = hessian(bending, shaken(shell, 0.05, 3), Curvature::convex);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(convex);
    EXPECT_GT(solver.eigenvalues()[0], -1e-10 * solver.eigenvalues().tail<1>()[0]);
    const Eigen::MatrixXd exact = hessian(bending, shell.rest, Curvature::exact);
    EXPECT_LT((exact - hessian(bending, shell.rest, Curvature::convex)).norm(), 1e-9 * exact.norm());
}

// Mechanisms would let a sheet crumple for nothing: of a free shell only the rigid motions, and of a flat one
// all motions in its plane, may cost no bending.
TEST(CoupledBending, FlatSheetHasNoModesWithoutEnergyButItsPlanes) {
    const Shell shell = flat();
    const CoupledBending bending(shell, {});
    const Eigen::MatrixXd all = hessian(bending, shell.rest, Curvature::exact);
    const Eigen::Index count = shell.rest.cols();
    Eigen::MatrixXd out_of_plane(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j) out_of_plane(i, j) = all(3 * i + 2, 3 * j + 2);
    const VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(out_of_plane).eigenvalues();
    EXPECT_LT(eigenvalues[2], 1e-9 * eigenvalues[count - 1]);  // a translation and two rotations
    EXPECT_GT(eigenvalues[3], 1e-5 * eigenvalues[count - 1]);
}

/// Height of a quadratic surface.
double quadratic(double x, double y) {
    return 0.5 * x * x + 0.7 * x * y - 0.3 * y * y;
}

// The property that makes the model converge, and that the plain hinge lacks.
TEST(CoupledBending, QuadraticSurfaceHasItsCurvatureInEveryFaceButAtFreeEdges) {
    const Shell shell = flat();
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

// At a symmetry plane and at a clamp the faces know the other half of the surface.
TEST(CoupledBending, SurfaceHasItsCurvatureBesideMirrors) {
    Shell shell = flat();
    const double amplitude = 1e-6;
    Positions x = shell.rest;  // its slope is zero across both mirrors
    for (Index v = 0; v < x.cols(); ++v) x(2, v) = amplitude * (0.5 * x(0, v) * x(0, v) - x(1, v) * x(1, v));
    const Eigen::Matrix3Xd curvatures = CoupledBending(shell, mirrors(shell)).curvatures(x);
    const std::array<Index, 3>& corner = shell.triangles[1].vertices;  // of both mirrors
    EXPECT_EQ(*std::ranges::min_element(corner), 0);
    EXPECT_NEAR((curvatures(0, 1) + curvatures(1, 1)) / amplitude, -1, 1e-6);
}

// Damping measures from another shape than rest.
TEST(CoupledBending, StartsFromAnyShape) {
    const Shell shell = curved();
    CoupledBending bending(shell, {});
    const Positions from = shaken(shell, 0.05, 5), x = shaken(shell, 0.05, 6);
    const VectorXd between = bending.changes(x) - bending.changes(from);
    bending.start_from(from, 3);
    EXPECT_LT(bending.value(from), 1e-24);
    EXPECT_LT((bending.changes(x) - between).norm(), 1e-12);
    test::expect_derivatives(bending, x, 1e-5, 1e-7);
}

}  // namespace
}  // namespace sherd
