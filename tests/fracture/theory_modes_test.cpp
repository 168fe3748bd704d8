// SPDX-License-Identifier: GPL-3.0-or-later
// Natural frequencies beside plate theory. The plain hinge is known to be off: its bounds are what was
// measured plus a little, and fail when the model gets worse, or better than its documentation says. Coupled
// hinges converge: what is left is mostly the lumped mass.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <numbers>

#include "tests/support/random_shapes.h"
#include "tests/support/steps.h"
#include "tests/support/theory.h"

namespace sherd {
namespace {

using Eigen::MatrixXd;

/// Angular frequencies, 1/s, of the `count` slowest modes at rest, rigid motions included, ascending:
/// subspace iteration with the Hessian of an implicit Euler step, M / h^2 + K.
VectorXd frequencies(const Shell& sheet, BendingModel model, const std::vector<MirrorHinge>& mirrors,
                     int count, double step) {
    ShellEnergies shell(sheet, {.bending = {model, exact_jacobian(model)}, .mirrors = mirrors});
    Inertia inertia(sheet, Vector3d::Zero());
    std::vector<Energy*> energies = shell.elastic();
    energies.push_back(&inertia);
    TimeSpent spent;
    Potential potential(sheet, energies, spent);
    potential.begin(test::step_of(sheet, 0, step));
    BlockMatrix matrix = potential.hessian_pattern(sheet.rest);
    potential.hessian(sheet.rest, Curvature::exact, matrix);
    const std::unique_ptr<LinearSolver> solver = cholesky_solver();
    solver->analyze(matrix);
    if (!solver->factorize(matrix)) throw std::runtime_error("the rest shape is not stable");

    VectorXd mass(3 * sheet.mass.size());
    for (Eigen::Index v = 0; v < sheet.mass.size(); ++v)
        mass.segment<3>(3 * v).setConstant(sheet.fixed[v] ? 0 : sheet.mass[v]);
    test::Random random(1);
    MatrixXd modes(mass.size(), 2 * count);
    for (Eigen::Index i = 0; i < modes.size(); ++i) modes(i) = random.uniform(-1, 1);
    VectorXd shifted;
    for (int iteration = 0; iteration < 25; ++iteration) {
        const MatrixXd forces = mass.asDiagonal() * modes;
        MatrixXd solved(modes.rows(), modes.cols());
        for (Eigen::Index i = 0; i < modes.cols(); ++i) solved.col(i) = solver->solve(forces.col(i));
        const MatrixXd stiffness = solved.transpose() * forces;
        const MatrixXd inertia = solved.transpose() * mass.asDiagonal() * solved;
        const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> small(
            0.5 * (stiffness + stiffness.transpose()), inertia);
        modes = solved * small.eigenvectors();
        shifted = small.eigenvalues();
    }
    return (shifted.head(count).array() - 1 / (step * step)).max(0).sqrt();
}

std::vector<double> percent_errors(const VectorXd& measured, const std::vector<double>& theory) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < theory.size(); ++i)
        errors.push_back(100 * (measured[static_cast<Eigen::Index>(i)] / theory[i] - 1));
    return errors;
}

// omega a^2 sqrt(rho t / D) for nu = 0.3: converged Ritz values, up to 0.9 % under the upper bounds of
// Leissa, J. Sound Vib. 31 (1973), 257-293 (13.489, 19.789, 24.432, 35.024, 35.024, 61.526).
TEST(TheoryModes, FreeSquarePlate) {
    const std::vector<double> leissa{13.468, 19.596, 24.270, 34.801, 34.801, 61.093};
    for (const int edges : {10, 20, 40}) {
        const BreakableShell plate = test::flat_plate(1, 1, 1.0 / edges, test::unit_plate(0.3, 0.01));
        const auto errors = [&](BendingModel model, const char* name) {
            const VectorXd all = frequencies(plate.mechanics(), model, {}, 12, 0.1);
            EXPECT_LT(all.head(6).maxCoeff(), 0.1) << "rigid motions cost energy";
            std::vector<double> percent = percent_errors(all.tail(6), leissa);
            test::report(
                ("free square plate, modes 1 to 6, 1/" + std::to_string(edges) + ", " + name).c_str(),
                percent);
            return percent;
        };
        const std::vector<double> hinge = errors(BendingModel::cubic, "cubic");
        const std::array<double, 6> known{38, -2.3, -2.2, 21, 23, -5.4}, spread{4, 2, 4, 3, 3, 7};
        for (int i = 0; i < 6; ++i) EXPECT_NEAR(hinge[i], known[i], spread[i]) << "mode " << i + 1;
        for (const double error : errors(BendingModel::coupled, "coupled"))
            EXPECT_NEAR(error, 0, 800.0 / (edges * edges));
    }
}

// A narrow strip: beam theory with the rigidity D (1 - nu^2) of a free strip, and Saint-Venant torsion.
TEST(TheoryModes, CantileverStrip) {
    const double width = 0.1, poisson = 0.3;
    const double bend = std::sqrt(1 - poisson * poisson);
    const double twist = std::numbers::pi / 2 * std::sqrt(24 * (1 - poisson)) / width;
    const std::vector<double> theory{3.5160 * bend, 22.0345 * bend, 61.6972 * bend,
                                     twist,         120.902 * bend, 199.860 * bend};
    for (const int edges : {2, 4, 8}) {
        BreakableShell plate = test::flat_plate(1, width, width / edges, test::unit_plate(poisson, 0.001));
        Shell& sheet = plate.mechanics();
        const auto at_wall = test::select(sheet, [](const Vector3d& p) { return p.x() < 1e-9; });
        const auto mirrors = test::clamp(sheet, at_wall, sheet.hinges.front().stiffness);
        const auto errors_of = [&](BendingModel model, const char* name) {
            std::vector<double> percent = percent_errors(frequencies(sheet, model, mirrors, 6, 0.1), theory);
            test::report(("cantilever strip, modes 1 to 6, b/" + std::to_string(edges) + ", " + name).c_str(),
                         percent);
            return percent;
        };
        const std::vector<double> errors = errors_of(BendingModel::cubic, "cubic");
        for (const int bending_mode : {0, 1, 2, 4, 5})
            EXPECT_NEAR(errors[bending_mode], 0, 16.0 / edges + 1.5) << bending_mode;
        EXPECT_GT(errors[3], 15) << "the twisting mode is known to be stiff: correct core/bending/README.md";
        EXPECT_LT(errors[3], 55);
        // The wall keeps the strip from narrowing, which beam theory knows nothing of.
        for (const double error : errors_of(BendingModel::coupled, "coupled"))
            EXPECT_NEAR(error, 1, 64.0 / (edges * edges) + 1);
    }
}

}  // namespace
}  // namespace sherd
