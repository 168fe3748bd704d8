// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vibration/vibration.h"

#include <gtest/gtest.h>

#include "core/solver/potential.h"
#include "core/vibration/rigid_motions.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

using Eigen::MatrixXd;

Shell plate(int count) {
    return test::stacked_plates(1, count, 0, test::ceramic);
}

/// Stiffness of a shell with its loads. Rows of blocked coordinates are those of the identity.
MatrixXd stiffness_of(const Shell& shell, const ShellEnergyOptions& options) {
    ShellEnergies energies(shell, options);
    std::vector<Energy*> all = energies.elastic();
    for (Energy* load : energies.loads()) all.push_back(load);
    TimeSpent spent;
    Potential potential(shell, all, spent);
    potential.begin({1, 0, 0, shell.position, shell.velocity, {}});
    BlockMatrix matrix = potential.hessian_pattern(shell.position);
    potential.hessian(shell.position, Curvature::exact, matrix);
    return test::dense(matrix);
}

/// All eigenvalues by Eigen, in the coordinates that are free, ascending.
VectorXd dense_eigenvalues(const Shell& shell, const ShellEnergyOptions& options) {
    std::vector<Eigen::Index> free;
    for (Eigen::Index i = 0; i < 3 * shell.mass.size(); ++i)
        if (!shell.fixed[i / 3] &&
            (shell.guide[i / 3] == 0 || shell.guides[shell.guide[i / 3] - 1](i % 3, i % 3) > 0.5))
            free.push_back(i);
    const VectorXd mass = shell.mass.replicate(1, 3).transpose().reshaped();
    const VectorXd root = mass(free).cwiseSqrt().cwiseInverse();
    const MatrixXd scaled = root.asDiagonal() * stiffness_of(shell, options)(free, free) * root.asDiagonal();
    return test::eigenvalues(scaled);
}

/// A plate that is pinned at one corner and guided at two others, in the planes across x and across y, under
/// a pressure with a ramp.
struct HeldPlate {
    Shell shell = plate(6);
    ShellEnergyOptions options;

    explicit HeldPlate(BendingModel model) {
        shell.fixed[0] = 1;
        shell.guides = {Vector3d(0, 1, 1).asDiagonal(), Vector3d(1, 0, 1).asDiagonal()};
        shell.guide[6] = 1;
        shell.guide[42] = 2;
        Load load{.dead = {}, .pressed = {}, .pressure = 1e7, .ramp = 1};
        for (Index t = 0; t < static_cast<Index>(shell.triangles.size()); ++t) load.pressed.push_back(t);
        options = {.bending = {model, exact_jacobian(model)}, .loads = {load}};
    }
};

class VibrationModels : public testing::TestWithParam<BendingModel> {};
INSTANTIATE_TEST_SUITE_P(All, VibrationModels,
                         testing::Values(BendingModel::cubic, BendingModel::nonlinear,
                                         BendingModel::coupled));

// Loads must act at their full size, and coordinates that pins block must not take part.
TEST_P(VibrationModels, AreThoseOfADenseSolver) {
    const HeldPlate held(GetParam());
    const Vibration found = vibration(held.shell, held.options, 15);
    EXPECT_EQ(found.freedoms, 3 * 49 - 5);
    EXPECT_EQ(found.rigid, 0);
    ASSERT_EQ(found.modes.size(), 15u);
    const VectorXd dense = dense_eigenvalues(held.shell, held.options);
    EXPECT_LT(dense[0], 0) << "the pressure is too small to show";
    for (int i = 0; i < 15; ++i)
        EXPECT_NEAR(found.modes[i].eigenvalue, dense[i], 1e-8 * std::abs(dense[i]) + 1e-13 * dense.tail(1)[0])
            << i;
}

// Shapes must be eigenvectors that satisfy the pins.
TEST_P(VibrationModels, SolveTheEquationAndAreOrthonormal) {
    const HeldPlate held(GetParam());
    const MatrixXd stiffness = stiffness_of(held.shell, held.options);
    const VectorXd mass = held.shell.mass.replicate(1, 3).transpose().reshaped();
    const Vibration found = vibration(held.shell, held.options, 8);
    for (std::size_t i = 0; i < found.modes.size(); ++i) {
        const VectorXd u = found.modes[i].shape.reshaped();
        EXPECT_TRUE(found.modes[i].shape.col(0).isZero(0));
        EXPECT_EQ(found.modes[i].shape(0, 6), 0);
        EXPECT_EQ(found.modes[i].shape(1, 42), 0);
        const VectorXd inertia = found.modes[i].eigenvalue * mass.cwiseProduct(u);
        EXPECT_LT((stiffness * u - inertia).norm(), 1e-11 * stiffness.norm() * u.norm()) << i;
        for (std::size_t j = 0; j <= i; ++j)
            EXPECT_NEAR(mass.cwiseProduct(u).dot(found.modes[j].shape.reshaped()), i == j, 1e-9);
    }
}

// A free plate has six rigid motions, and a plate with too few supports has some; they must not displace
// modes in the list.
TEST(Vibration, TellsRigidMotionsApart) {
    const auto rigid = [](const Shell& shell, const ShellEnergyOptions& options = {}) {
        const Vibration found = vibration(shell, options, 3);
        EXPECT_GT(found.modes.front().eigenvalue, 1e4) << "a rigid motion among the modes";
        return found.rigid;
    };
    Shell shell = plate(6);
    EXPECT_EQ(rigid(shell), 6);
    EXPECT_EQ(rigid(test::stacked_plates(3, 4, 0.1, test::ceramic)), 18);
    EXPECT_EQ(rigid(shell, {.bending = {BendingModel::coupled}}), 6);
    shell.fixed[0] = 1;
    EXPECT_EQ(rigid(shell), 3);
    shell.fixed[6] = 1;
    EXPECT_EQ(rigid(shell), 1);
    std::vector<MirrorHinge> clamps;
    for (Index v = 0; v <= 6; ++v) shell.fixed[v] = 1;
    EXPECT_EQ(rigid(shell), 1);
    std::vector<char> selected = shell.fixed;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, selected))
        clamps.push_back(clamp_hinge(shell, side, shell.hinges.front().stiffness));
    EXPECT_EQ(rigid(shell, {.mirrors = clamps}), 0);
    EXPECT_EQ(rigid(shell, {.bending = {BendingModel::coupled}, .mirrors = clamps}), 0);
    shell.fixed[48] = 1;
    EXPECT_EQ(rigid(shell), 0);
}

// In a sheet as thin as paper far from the origin, the round-off of the membrane is comparable with the
// stiffness of bending.
TEST(Vibration, TellsRigidMotionsOfThinSheetsFarAway) {
    Shell shell = test::stacked_plates(1, 12, 0, {780, 1e-5, 3e9, 0.2});
    const double here = vibration(shell, {}, 1).modes[0].frequency();
    shell.rest.colwise() += Vector3d(10, -20, 30);
    shell.position = shell.rest;
    const Vibration there = vibration(shell, {}, 1);
    EXPECT_EQ(there.rigid, 6);
    EXPECT_NEAR(there.modes[0].frequency(), here, 0.05 * here);
}

// Lanczos' method finds only one of several equal frequencies; with five equal plates in a scene, each
// frequency must be found five times.
TEST(Vibration, FindsFrequenciesAsOftenAsTheyAre) {
    const Shell one = plate(4);
    const Vibration single = vibration(one, {}, 4);
    const int copies = 5;
    const auto count = static_cast<Index>(one.mass.size());
    Positions rest(3, copies * count);
    std::vector<std::array<Index, 3>> triangles;
    for (int k = 0; k < copies; ++k) {
        rest.middleCols(k * count, count) = one.rest.colwise() + Vector3d(0, 0, 0.25 * k);
        for (const TriangleStencil& triangle : one.triangles)
            triangles.push_back(numbered_from(triangle.vertices, -k * count));
    }
    const Vibration all = vibration(test::small_sheet(rest, triangles, test::ceramic), {}, 18);
    EXPECT_EQ(all.rigid, 30);
    ASSERT_EQ(all.modes.size(), 18u);
    for (std::size_t i = 0; i < all.modes.size(); ++i)
        EXPECT_NEAR(all.modes[i].eigenvalue / single.modes[i / copies].eigenvalue, 1, 1e-7) << i;
}

// A mesh of two triangles has six modes beside its rigid motions; a request for more modes returns all.
TEST(Vibration, OfTheSmallestSheetIsComplete) {
    const Shell shell = test::two_triangles(test::rubber);
    const Vibration found = vibration(shell, {}, 100);
    EXPECT_EQ(found.freedoms, 12);
    EXPECT_EQ(found.rigid, 6);
    ASSERT_EQ(found.modes.size(), 6u);
    const VectorXd dense = dense_eigenvalues(shell, {});
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(found.modes[i].eigenvalue / dense[6 + i], 1, 1e-8) << i;
    Shell held = shell;
    held.fixed = {1, 1, 1, 1};
    const Vibration none = vibration(held, {}, 3);
    EXPECT_EQ(none.freedoms + none.rigid + static_cast<Index>(none.modes.size()), 0);
}

// A plate that is compressed beyond its buckling load has an unstable mode, with its growth rate.
TEST(Vibration, ASheetUnderTooMuchPressureIsUnstable) {
    Shell shell = plate(8);
    for (Index v = 0; v < 81; ++v) shell.fixed[v] = v % 9 == 0 || v % 9 == 8 || v < 9 || v >= 72;
    EXPECT_GT(vibration(shell, {}, 1).modes[0].eigenvalue, 0);
    shell.position.row(0) *= 0.99;
    const Vibration pressed = vibration(shell, {}, 6);
    const VectorXd dense = dense_eigenvalues(shell, {});
    EXPECT_TRUE(pressed.modes[0].unstable());
    EXPECT_EQ(pressed.modes[0].frequency(), 0);
    EXPECT_NEAR(pressed.modes[0].growth_rate(), std::sqrt(-dense[0]), 1e-6 * std::sqrt(-dense[0]));
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(pressed.modes[i].eigenvalue / dense[i], 1, 1e-6) << i;
}

// The frequency must be the one at which a run vibrates: from rest in a mode's shape the sheet is back in its
// plane after a quarter of the period.
TEST(Vibration, IsThatOfARun) {
    Shell shell = plate(4);
    for (Index v = 0; v <= 4; ++v) shell.fixed[v] = 1;
    const VibrationMode mode = vibration(shell, {}, 2).modes[1];
    constexpr int steps_of_quarter = 100;
    StepperOptions options;
    options.gravity.setZero();
    options.tolerance = 1e-12;
    options.step = 0.25 / (mode.frequency() * steps_of_quarter);
    shell.position += 1e-5 / mode.shape.maxCoeff() * mode.shape;
    ImplicitStepper stepper(shell, options);
    const auto deflection = [&] {
        const Positions moved = (shell.position - shell.rest) * shell.mass.asDiagonal();
        return moved.cwiseProduct(mode.shape).sum();
    };
    double before = deflection();
    int steps = 0;
    for (; deflection() > 0 && steps < 2 * steps_of_quarter; ++steps) {
        before = deflection();
        test::advance(stepper);
    }
    const double crossing = steps - deflection() / (deflection() - before);
    EXPECT_NEAR(crossing, steps_of_quarter, 0.2);
}

// Modes of two runs of the same scene must be equal bit for bit.
TEST(Vibration, IsTheSameToTheLastBit) {
    const Vibration one = vibration(plate(6), {}, 5), two = vibration(plate(6), {}, 5);
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(one.modes[i].eigenvalue, two.modes[i].eigenvalue);
        EXPECT_EQ(one.modes[i].shape, two.modes[i].shape);
    }
}

// The share along normals distinguishes bending from stretching.
TEST(Vibration, OfAPlateBendsOutOfItsPlane) {
    const Shell shell = plate(6);
    const Vibration found = vibration(shell, {}, 100);
    EXPECT_NEAR(share_along_normals(shell, shell.position, found.modes[0].shape), 1, 1e-9);
    EXPECT_NEAR(share_along_normals(shell, shell.position, found.modes.back().shape), 0, 1e-9);
}

}  // namespace
}  // namespace sherd
