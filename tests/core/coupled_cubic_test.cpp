// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bending/coupled_cubic_bending.h"
#include "core/vibration/vibration.h"
#include "tests/support/uneven_patch.h"

namespace sherd {
namespace {

using Form = CoupledCubicBending::Form;
using Eigen::MatrixXd;

Shell thin(Shell shell) {
    shell.thickness.setConstant(0.01);
    return shell;
}

std::ptrdiff_t count(const CoupledCubicBending& bending, Form form) {
    return std::ranges::count(bending.forms(), form);
}

/// A crumpled sheet whose triangles are up to thirty times as long as wide.
Shell needles() {
    Shell shell = test::uneven_patch(
        [](double x, double y) { return Vector3d(x, 0.04 * y, 4e-4 * std::sin(5 * x + 8 * y)); });
    shell.thickness.setConstant(1e-4);
    return shell;
}

// A wrong sign or factor in the forces, or a pair of vertices that the pattern misses, would show here.
TEST(CoupledCubic, DerivativesAreThoseOfTheValue) {
    Shell shells[] = {thin(test::flat_patch()), thin(test::curved_patch()), test::curved_patch(), needles()};
    for (Shell& shell : shells) {
        const double amplitude = shell.thickness[0] < 1e-3 ? 1e-3 : 0.03;
        const CoupledCubicBending free(shell, {}), held(shell, test::patch_mirrors(shell));
        EXPECT_GT(count(free, Form::polynomial), 10);
        EXPECT_GT(count(held, Form::beside_mirror), 10);
        const Positions x = test::shaken(shell, amplitude, 1);
        test::expect_derivatives(free, x, amplitude / 3000, 1e-7);
        test::expect_derivatives(held, x, amplitude / 3000, 1e-7);
    }
}

// Sheets must neither move nor spin by their own bending, and must stay as they are made.
TEST(CoupledCubic, RestIsEquilibriumAndRigidMotionCostsNothing) {
    Shell shells[] = {thin(test::flat_patch()), thin(test::curved_patch()), needles()};
    for (Shell& shell : shells) {
        const CoupledCubicBending bending(shell, {}), held(shell, test::patch_mirrors(shell));
        const double amplitude = shell.thickness[0] < 1e-3 ? 1e-3 : 0.03;
        const Positions x = test::shaken(shell, amplitude, 2), force = test::gradient_of(bending, x);
        const double energy = bending.value(x);
        test::Random random(3);
        const Positions moved = (random.rotation() * shell.rest).colwise() + random.matrix<Vector3d>(2);
        EXPECT_LT(std::abs(bending.value(moved)), 1e-10 * std::abs(energy));
        EXPECT_LE(std::abs(bending.value(shell.rest)), bending.round_off());
        EXPECT_LT(test::gradient_of(bending, moved).norm(), 1e-9 * force.norm());
        EXPECT_LT(test::gradient_of(held, shell.rest).norm(), 1e-9 * force.norm());

        Vector3d torque = Vector3d::Zero();
        for (Index v = 0; v < x.cols(); ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
        EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
        EXPECT_LT(torque.norm(), 1e-12 * force.norm());
        const Positions x_moved = (random.rotation() * x).colwise() + random.matrix<Vector3d>(2);
        EXPECT_NEAR(bending.value(x_moved), energy, 1e-10 * std::abs(energy));
    }
}

/// An orthonormal basis of the motions of a shell at rest that change no edge's length.
MatrixXd inextensional(const Shell& shell) {
    MatrixXd lengths =
        MatrixXd::Zero(3 * static_cast<Eigen::Index>(shell.triangles.size()), shell.rest.size());
    Eigen::Index row = 0;
    for (const TriangleStencil& triangle : shell.triangles)
        for (int c = 0; c < 3; ++c, ++row) {
            const Index a = triangle.vertices[c], b = triangle.vertices[(c + 1) % 3];
            const Vector3d along = (shell.rest.col(a) - shell.rest.col(b)).normalized();
            lengths.block<1, 3>(row, 3 * a) = along.transpose();
            lengths.block<1, 3>(row, 3 * b) = -along.transpose();
        }
    const Eigen::ColPivHouseholderQR<MatrixXd> decomposition(lengths.transpose());
    const MatrixXd all = decomposition.householderQ();
    return all.rightCols(all.cols() - decomposition.rank());
}

// What makes it a model of the same shell: to second order it is the energy of true angles.
TEST(CoupledCubic, HessianAtRestIsThatOfTrueAnglesForMotionsWithoutStretch) {
    Shell shells[] = {thin(test::flat_patch()), thin(test::curved_patch()), needles()};
    for (Shell& shell : shells) {
        const CoupledCubicBending cubic(shell, {});
        EXPECT_EQ(count(cubic, Form::polynomial), static_cast<std::ptrdiff_t>(shell.triangles.size()));
        const MatrixXd modes = inextensional(shell);
        EXPECT_GE(modes.cols(), 23) << "6 rigid motions and 17 that bend";
        const auto stiffness = [&](const Energy& energy) {
            const MatrixXd all = test::hessian_of(energy, shell.rest, Curvature::exact);
            return MatrixXd(modes.transpose() * all * modes);
        };
        const MatrixXd exact = stiffness(cubic.hinges()), all = stiffness(CoupledBending(shell, {}));
        EXPECT_EQ(exact.norm(), 0) << "no face counts twice";
        EXPECT_LT((stiffness(cubic) - all).norm(), 1e-9 * all.norm());
        EXPECT_GT(all.norm(), 0);
    }
}

/// A sheet of 12 by 4 squares that is bent along its lines by `angle` at each, which stretches nothing.
Positions rolled(double angle) {
    Positions x(3, 13 * 5);
    Vector3d at = Vector3d::Zero();
    for (int i = 0; i < 13; ++i) {
        for (int j = 0; j < 5; ++j) x.col(5 * i + j) = at + Vector3d(0, 0.1 * j, 0);
        at += 0.1 * Vector3d(std::cos(i * angle), 0, std::sin(i * angle));
    }
    return x;
}

Shell rolled_sheet(double angle) {
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 0; i < 12; ++i)
        for (Index j = 0; j < 4; ++j) {
            const Index a = 5 * i + j, b = a + 5, c = b + 1, d = a + 1;
            if ((i + j) % 2 == 0)
                triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
            else
                triangles.insert(triangles.end(), {{b, c, d}, {a, b, d}});
        }
    return test::small_sheet(rolled(angle), triangles, {1000, 0.01, 1e9, 0.3});
}

// How far a sheet may bend without stretch before the polynomial's energy is another one.
TEST(CoupledCubic, EnergyStaysThatOfTrueAnglesWhereSheetsRollUp) {
    constexpr double degree = std::numbers::pi / 180;
    for (const double rest : {0.0, 10.0, 20.0}) {
        const Shell shell = rolled_sheet(rest * degree);
        const CoupledCubicBending cubic(shell, {});
        const CoupledBending angles(shell, {});
        EXPECT_EQ(count(cubic, Form::polynomial), static_cast<std::ptrdiff_t>(shell.triangles.size()));
        std::printf("angle at rest %2.0f degrees, change and error of the energy:", rest);
        for (const double change : {5.0, 10.0, 20.0, 40.0}) {
            const Positions x = rolled((rest + change) * degree);
            const double error = cubic.value(x) / angles.value(x) - 1;
            std::printf("  %2.0f %.2f %%", change, 100 * error);
            EXPECT_LT(std::abs(error), 0.05 * std::pow(change / 40, 2)) << rest << " and " << change;
        }
        std::printf("\n");
    }
}

// Newton's method goes on with it where the Hessian itself is indefinite.
TEST(CoupledCubic, ConvexHessianIsSemidefiniteAndResistsBendingAsMuch) {
    Shell shell = thin(test::curved_patch());
    const CoupledCubicBending bending(shell, test::patch_mirrors(shell));
    const Positions x = test::shaken(shell, 0.05, 3);
    const VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<MatrixXd>(test::hessian_of(bending, x, Curvature::convex))
            .eigenvalues();
    EXPECT_GT(eigenvalues[0], -1e-10 * eigenvalues.tail<1>()[0]);
    const Shell flat = thin(test::flat_patch());
    const CoupledCubicBending plane(flat, {});
    const MatrixXd exact = test::hessian_of(plane, flat.rest, Curvature::exact);
    EXPECT_LT((exact - test::hessian_of(plane, flat.rest, Curvature::convex)).norm(), 1e-9 * exact.norm());
}

// Beyond these limits the polynomial stiffens sheets, or is indefinite.
TEST(CoupledCubic, CreasesThickSheetsAndMirrorsKeepTrueAngles) {
    constexpr double degree = std::numbers::pi / 180;
    Shell shell = rolled_sheet(50 * degree);
    const auto faces = static_cast<std::ptrdiff_t>(shell.triangles.size());
    const CoupledCubicBending sharp(shell, {});
    EXPECT_EQ(count(sharp, Form::crease), faces);
    const Positions x = test::shaken(shell, 0.01, 1);
    EXPECT_EQ(sharp.value(x), CoupledBending(shell, {}).value(x)) << "with no polynomial it is the same";

    shell = rolled_sheet(30 * degree);
    EXPECT_GT(count(CoupledCubicBending(shell, {}), Form::unsuited), 0) << "three folds in a row";

    shell = rolled_sheet(15 * degree);
    EXPECT_EQ(count(CoupledCubicBending(shell, {}), Form::polynomial), faces);
    shell.thickness.setConstant(0.026);
    EXPECT_EQ(count(CoupledCubicBending(shell, {}), Form::thick), faces);

    Shell patch = thin(test::curved_patch());
    const CoupledCubicBending held(patch, test::patch_mirrors(patch));
    EXPECT_GT(count(held, Form::beside_mirror), 15);
    EXPECT_GT(count(held, Form::polynomial), 15);
    const CoupledBending angles(patch, test::patch_mirrors(patch));
    const Positions bent = test::shaken(patch, 0.01, 1);
    EXPECT_EQ((held.hinges().curvatures(bent) - angles.curvatures(bent)).norm(), 0) << "of all faces";
    ASSERT_EQ(held.hinges().mirror_gradients(bent).size(), angles.mirror_gradients(bent).size());
    for (std::size_t m = 0; m < angles.mirror_gradients(bent).size(); ++m) {
        const HingePositions one = held.hinges().mirror_gradients(bent)[m].gradient,
                             other = angles.mirror_gradients(bent)[m].gradient;
        EXPECT_LT((one - other).norm(), 1e-12 * other.norm()) << m;
    }
}

// A tetrahedron's corner, where folds and triangles around a face are there twice.
TEST(CoupledCubic, ClosesAroundVerticesOfThreeTriangles) {
    Positions rest(3, 7);
    for (int i = 0; i < 3; ++i) {
        const double turn = 2.0 * i;
        rest.col(1 + i) = Vector3d(std::cos(turn), std::sin(turn), -0.15);
        rest.col(4 + i) = Vector3d(2 * std::cos(turn + 1), 2 * std::sin(turn + 1), -0.4);
    }
    rest.col(0).setZero();
    const std::vector<std::array<Index, 3>> triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 1},
                                                      {2, 1, 4}, {3, 2, 5}, {1, 3, 6}};
    const Shell shell = thin(test::small_sheet(rest, triangles, test::patch_material));
    const CoupledCubicBending bending(shell, {});
    EXPECT_EQ(count(bending, Form::polynomial), 6);
    const Positions x = test::shaken(shell, 0.05, 1);
    test::expect_derivatives(bending, x, 1e-5, 1e-7);
    EXPECT_LT(test::gradient_of(bending, rest).norm(), 1e-10 * test::gradient_of(bending, x).norm());
}

// What the polynomial adds in the sheet's plane must not show, and no motion may be free.
TEST(CoupledCubic, FrequenciesOfCurvedPanelsAreThoseOfTrueAngles) {
    const Shell shell = test::uneven_patch(
        [](double x, double y) { return Vector3d(x, y, 0.3 * std::sin(2 * x) - 0.4 * y * y); });
    Shell panel = thin(shell);
    for (TriangleStencil& triangle : panel.triangles) triangle.membrane.elasticity *= 0.01 / 0.05;
    const auto modes = [&](BendingModel model) {
        return vibration(panel, {.bending = {model, exact_jacobian(model)}}, 8);
    };
    const Vibration angles = modes(BendingModel::coupled), cubic = modes(BendingModel::coupled_cubic);
    EXPECT_EQ(cubic.rigid, 6);
    ASSERT_EQ(cubic.modes.size(), 8u);
    std::printf("frequencies beside those of true angles:");
    for (std::size_t i = 0; i < cubic.modes.size(); ++i) {
        const double error = std::sqrt(cubic.modes[i].eigenvalue / angles.modes[i].eigenvalue) - 1;
        std::printf(" %.3f %%", 100 * error);
        EXPECT_LT(std::abs(error), 0.003) << i;
    }
    std::printf("\n");
}

}  // namespace
}  // namespace sherd
