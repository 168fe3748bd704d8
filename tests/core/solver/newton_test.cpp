// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/newton.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/bending/cubic_bending.h"
#include "core/membrane/membrane_energy.h"
#include "core/time/inertia.h"
#include "tests/support/shell/small_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

constexpr Index along = 30, row = 3;
constexpr double side = 0.01;  // m, side of the squares

/// Strip of rubber along x, held at both ends.
Shell strip() {
    const Material rubber{.density = 1000, .thickness = 1e-3, .young = 5e6, .poisson = 0.3};
    Positions rest(3, (along + 1) * row);
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 0; i <= along; ++i)
        for (Index j = 0; j < row; ++j) {
            const Index v = i * row + j;
            rest.col(v) = side * Vector3d(i, j, 0);
            if (i == along || j + 1 == row) continue;
            triangles.push_back({v, v + row, v + row + 1});
            triangles.push_back({v, v + row + 1, v + 1});
        }
    Shell shell = test::small_sheet(rest, triangles, rubber);
    for (Index j = 0; j < row; ++j) shell.fixed[j] = shell.fixed[along * row + j] = 1;
    return shell;
}

/// Shortens the strip by `strain`, beyond its buckling load, and makes it bow by a micrometre.
void press(Shell& shell, double strain) {
    shell.position.row(0) *= 1 - strain;
    for (Index v = 0; v < static_cast<Index>(shell.position.cols()); ++v)
        shell.position(2, v) = 1e-6 * std::sin(std::numbers::pi * shell.rest(0, v) / (along * side));
}

// A buckling sheet has an indefinite Hessian, and the convex Hessian without any compression is so stiff
// that Newton's method converges slowly: crushed thin shells could not be solved in 50 iterations (this
// strip took 160).
TEST(Newton, BucklesInFewIterations) {
    Shell shell = strip();
    press(shell, 1e-4);
    CubicBending bending(CubicHinges(shell.hinges, shell.rest));
    MembraneEnergy membrane(shell.triangles);
    Inertia inertia(shell, Vector3d::Zero());
    TimeSpent spent;
    Potential potential(shell, {&inertia, &bending, &membrane}, spent);
    potential.begin(test::step_of(shell, 0, 0.1));
    Positions x = shell.position;
    const MinimiserResult result = Newton(1e-8).minimise(potential, 200, x);
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.iterations, 40);
    EXPECT_GT(x.row(2).cwiseAbs().maxCoeff(), 1e-4) << "it did not buckle";
    EXPECT_LT(potential.gradient(x).cwiseAbs().maxCoeff(), 1e-6);
}

}  // namespace
}  // namespace sherd
