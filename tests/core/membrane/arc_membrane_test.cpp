// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/membrane/arc_membrane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/bending/patches.h"
#include "core/forces/shell_energies.h"
#include "core/membrane/membrane.h"
#include "core/membrane/membrane_energy.h"
#include "core/shell/face_fields.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

/// Position of the point (s, y) of a sheet that is rolled about an axis along y.
Vector3d on_cylinder(double s, double y, double radius) {
    return {radius * std::sin(s / radius), y, radius * (1 - std::cos(s / radius))};
}

// With a wrong sign or factor in the forces, or a pair of vertices missing in the pattern, sheets would move
// wrongly or the solver would not converge.
TEST(ArcMembrane, DerivativesAreThoseOfTheValue) {
    Shell flat_sheet = test::flat_patch(), shell = test::curved_patch();
    for (Shell* sheet : {&flat_sheet, &shell}) {
        const ArcMembrane free(*sheet, {}), held(*sheet, test::patch_mirrors(*sheet));
        const Positions x = test::shaken(*sheet, 0.03, 1);
        test::expect_derivatives(free, x, 1e-5, 1e-7);
        test::expect_derivatives(held, x, 1e-5, 1e-7);
    }
}

// Sheets must neither move nor spin by their own stretching, and must keep their rest shape.
TEST(ArcMembrane, RestIsEquilibriumAndRigidMotionCostsNothing) {
    Shell shell = test::curved_patch();
    const ArcMembrane membrane(shell, {});
    test::Random random(3);
    const Positions x = test::shaken(shell, 0.05, 2), force = test::gradient_of(membrane, x);
    const Positions moved = (random.rotation() * shell.rest).colwise() + random.matrix<Vector3d>(2);
    EXPECT_LT(membrane.value(moved), 1e-24 * membrane.value(x));
    EXPECT_LT(test::gradient_of(membrane, moved).norm(), 1e-11 * force.norm());
    EXPECT_LT(membrane.value(shell.rest), 1e-24 * membrane.value(x));
    EXPECT_LT(test::gradient_of(ArcMembrane(shell, test::patch_mirrors(shell)), shell.rest).norm(),
              1e-11 * force.norm());

    Vector3d torque = Vector3d::Zero();
    for (Index v = 0; v < x.cols(); ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
    EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
    EXPECT_LT(torque.norm(), 1e-12 * force.norm());
    const Positions x_moved = (random.rotation() * x).colwise() + random.matrix<Vector3d>(2);
    EXPECT_NEAR(membrane.value(x_moved), membrane.value(x), 1e-11 * membrane.value(x));
}

// Newton's method uses the convex Hessian where the exact one is indefinite, as under compression.
TEST(ArcMembrane, ConvexHessianIsSemidefiniteAndExactAtRest) {
    Shell shell = test::curved_patch();
    const ArcMembrane membrane(shell, test::patch_mirrors(shell));
    for (const Positions& x : {Positions(0.9 * shell.rest), test::shaken(shell, 0.05, 3)}) {
        const VectorXd convex = test::eigenvalues(test::hessian_of(membrane, x, Curvature::convex));
        EXPECT_GT(convex[0], -1e-10 * convex.tail<1>()[0]);
        const VectorXd exact = test::eigenvalues(test::hessian_of(membrane, x, Curvature::exact));
        EXPECT_LT(exact[0], -1e-6 * convex.tail<1>()[0]) << "not a case where the two differ";
    }
    const Eigen::MatrixXd exact = test::hessian_of(membrane, shell.rest, Curvature::exact);
    EXPECT_LT((exact - test::hessian_of(membrane, shell.rest, Curvature::convex)).norm(),
              1e-9 * exact.norm());
}

// For motions in its plane the sides of a flat sheet stay straight: both membrane models must agree.
TEST(ArcMembrane, FlatSheetInItsPlaneIsThatOfConstantStrain) {
    const Shell shell = test::flat_patch();
    const ArcMembrane arcs(shell, {});
    const MembraneEnergy flat(shell.triangles);
    Positions x = test::shaken(shell, 0.02, 4);
    x.row(2).setZero();
    EXPECT_NEAR(arcs.value(x), flat.value(x), 1e-12 * flat.value(x));
    const Positions force = test::gradient_of(flat, x);
    EXPECT_LT((test::gradient_of(arcs, x) - force).norm(), 1e-11 * force.norm());
    const Eigen::MatrixXd stiffness = test::hessian_of(flat, x, Curvature::exact);
    Eigen::MatrixXd in_plane = test::hessian_of(arcs, x, Curvature::exact) - stiffness;
    for (Eigen::Index i = 2; i < in_plane.rows(); i += 3) in_plane.row(i).setZero();
    EXPECT_LT(in_plane.norm(), 1e-10 * stiffness.norm());
}

// The membrane of constant strain takes the rolling of a sheet for strain; arcs must not, inside, beside
// symmetry planes and at free edges.
TEST(ArcMembrane, RolledSheetHasHardlyAnyStrain) {
    constexpr double radius = 1;
    Shell shell = test::flat_patch();
    Positions x = shell.rest;
    for (Index v = 0; v < x.cols(); ++v) x.col(v) = on_cylinder(x(0, v), x(1, v), radius);
    const double chords = MembraneEnergy(shell.triangles).value(x);
    EXPECT_LT(ArcMembrane(shell, {}).value(x), 1e-3 * chords);
    const auto mirrors = test::patch_mirrors(shell);
    EXPECT_LT(ArcMembrane(shell, mirrors).value(x), 1e-3 * chords);
    EXPECT_LT(ArcMembrane(shell, {}).strains(x).cwiseAbs().maxCoeff(), 5e-4);
}

// Only the change of curvature from rest may count: a piece of a cylinder unrolls and rolls up further
// without strain.
TEST(ArcMembrane, CylinderUnrollsWithHardlyAnyStrain) {
    const Shell shell = test::uneven_patch([](double s, double y) { return on_cylinder(s, y, 1); });
    for (const double radius : {1e9, 0.7}) {
        const Shell other = test::uneven_patch([&](double s, double y) { return on_cylinder(s, y, radius); });
        const double chords = MembraneEnergy(shell.triangles).value(other.rest);
        EXPECT_LT(ArcMembrane(shell, {}).value(other.rest), 1e-3 * chords);
    }
}

// A crease in the rest shape must not count as curvature: arcs beside it would resist its turning as if they
// were stretched.
TEST(ArcMembrane, CreaseTurnsFreely) {
    const auto folded = [](double angle) {
        return test::uneven_patch([=](double x, double y) {
            const double beyond = std::abs(x - 0.6) < 0.06 ? 0 : x - 0.6;  // some vertices are on the crease
            const Vector2d way = beyond < 0 ? Vector2d(1, 0) : Vector2d(std::cos(angle), std::sin(angle));
            return Vector3d(0.6 + beyond * way.x(), y, beyond * way.y());
        });
    };
    const Shell crease = folded(1.2), turned = folded(1.5);
    const ArcMembrane membrane(crease, {});
    const double stretched = membrane.value(1.01 * crease.rest);
    EXPECT_LT(membrane.value(turned.rest), 1e-6 * stretched);
}

// Damping measures strains from another shape than the rest shape.
TEST(ArcMembrane, StartsFromAnyShape) {
    const Shell shell = test::curved_patch();
    ArcMembrane membrane(shell, {});
    const Positions from = test::shaken(shell, 0.03, 5), x = test::shaken(shell, 0.03, 6);
    const double energy = membrane.value(x);
    membrane.start_from(shell.rest, 3);
    EXPECT_NEAR(membrane.value(x), 3 * energy, 1e-10 * energy);
    membrane.start_from(from, 3);
    EXPECT_LT(membrane.value(from), 1e-24 * energy);
    test::expect_derivatives(membrane, x, 1e-5, 1e-7);
}

// `sherd check` warns of a rolled sheet by the number h^2 / (R t), with the edge length h, the radius R and
// the thickness t.
TEST(ArcMembrane, LockingIsToldFromRadiusAndEdges) {
    const Shell shell = test::uneven_patch([](double s, double y) { return on_cylinder(s, y, 2); });
    double longest = 0;  // m, longest extent of a side around the cylinder, along which the side is curved
    for (const TriangleStencil& triangle : shell.triangles) {
        const auto sides = columns(shell.rest, triangle.vertices);
        for (int side = 0; side < 3; ++side)
            longest = std::max(longest, std::abs(sides(0, side) - sides(0, (side + 1) % 3)));
    }
    const double expected = longest * longest / (2 * test::patch_material.thickness);
    EXPECT_NEAR(locking(shell).maxCoeff(), expected, 0.1 * expected) << "as far as this coarse mesh knows";
    EXPECT_LT(locking(test::flat_patch()).maxCoeff(), 1e-12);
}

// `sherd check` examines sheets no further that cannot lock by this bound on the curvature along a side.
TEST(ArcMembrane, NoSideIsMoreCurvedThanFoldsAllow) {
    const Shell shell = test::curved_patch();
    const Folds folds(shell, {});
    const VectorXd angles = folds.rest_angles();
    const SideCurvature curvature(shell, folds);
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        const Vector3d lengths =
            side_squares(columns(shell.rest, shell.triangles[face].vertices)).cwiseSqrt();
        const Vector3d of_sides = curvature.of(face, angles);
        for (int side = 0; side < 3; ++side)
            EXPECT_LE(std::abs(of_sides[side]),
                      most_side_curvature(lengths[side], angles.cwiseAbs().maxCoeff()));
    }
}

// With other strains than those of the energy, fields, gauges and fracture would take bending for stretch.
TEST(ArcMembrane, StrainsOfFacesAreThoseOfItsEnergy) {
    const Shell shell = test::curved_patch();
    const Positions x = test::shaken(shell, 0.05, 4);
    const ShellEnergies with_arcs(shell, {.membrane = MembraneModel::arc}), with_chords(shell, {});
    const Eigen::Matrix3Xd arcs = with_arcs.face_strains(x), chords = with_chords.face_strains(x);
    double energy = 0;
    for (Eigen::Index f = 0; f < arcs.cols(); ++f) {
        const MembraneTriangle& membrane = shell.triangles[static_cast<std::size_t>(f)].membrane;
        energy += 0.5 * membrane.area * arcs.col(f).dot(membrane.elasticity * arcs.col(f));
    }
    EXPECT_NEAR(energy, with_arcs.membrane_value(x), 1e-12 * energy);
    EXPECT_EQ(chords, green_strains(shell, x));
    EXPECT_GT((arcs - chords).norm(), 1e-3 * chords.norm()) << "not a case where the two differ";
}

}  // namespace
}  // namespace sherd
