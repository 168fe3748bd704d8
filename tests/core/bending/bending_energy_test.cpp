// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of a bending model and a Jacobian, in whole time steps.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/bending/cubic_bending.h"
#include "core/bending/nonlinear_bending.h"
#include "core/time/implicit_stepper.h"

namespace sherd {
namespace {

using enum BendingModel;
constexpr int across = 3, around = 9;  // numbers of vertices along the tube's axis, and around it
const double edge_length = 0.02;
const Material tube_material{1000, 0.001, 1e7, 0.3};

Index vertex(int i, int j) {
    return across * i + j;
}

/// A quarter of a tube with `around` vertices around and `across` along its axis, and unequal triangles,
/// clamped at one end.
Shell arch() {
    Shell shell;
    resize_vertices(shell, around * across);
    const double radius = edge_length * (around - 1) / 1.57;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double turn = (i + 0.2 * std::sin(2.0 * i + 3.0 * j)) * edge_length / radius;
            shell.rest.col(vertex(i, j)) =
                Vector3d(radius * std::sin(turn), j * edge_length, radius * std::cos(turn));
            shell.fixed[vertex(i, j)] = i < 2;
        }
    shell.position = shell.rest;
    const Matrix3d elasticity = membrane_elasticity(tube_material);
    const auto add_triangle = [&](const std::array<Index, 3>& v) {
        shell.triangles.push_back({v, membrane_triangle(columns(shell.rest, v), elasticity)});
        for (const Index corner : v)
            shell.mass[corner] +=
                shell.triangles.back().membrane.area * tube_material.thickness * tube_material.density / 3;
    };
    const auto add_hinge = [&](const std::array<Index, 4>& v) {
        shell.hinges.push_back(hinge_stencil(shell, v, hinge_stiffness(tube_material)));
    };
    for (int i = 0; i + 1 < around; ++i)
        for (int j = 0; j + 1 < across; ++j) {
            const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1),
                        d = vertex(i, j + 1);
            add_triangle({a, b, c});
            add_triangle({a, c, d});
            add_hinge({a, c, d, b});
            if (i > 0) add_hinge({a, d, vertex(i - 1, j), c});
            if (j > 0) add_hinge({a, b, c, vertex(i, j - 1)});
        }
    return shell;
}

/// Lets the arch swing under its weight for `steps` steps of 5 ms. Returns its last positions, and adds the
/// number of Newton's iterations to `iterations`.
Positions swung(const BendingOptions& bending, int steps, int& iterations) {
    Shell shell = arch();
    StepperOptions options;
    options.step = 5e-3;
    options.method = Method::newton;
    options.shell.bending = bending;
    options.tolerance = 1e-11;
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < steps; ++i) {
        time_step.begin();
        const StepResult result = time_step.solve(300);
        EXPECT_TRUE(result) << "step " << i;
        iterations += result.iterations;
        time_step.finish();
    }
    return shell.position;
}

// The energy alone determines where a step ends: an approximate Jacobian must neither end the step early nor
// lead to other positions.
TEST(BendingEnergy, EveryJacobianLeadsToTheSamePositions) {
    for (const BendingModel model : {cubic, cubic_2007, nonlinear}) {
        int exact_iterations = 0;
        const Positions exact = swung({model, exact_jacobian(model)}, 10, exact_iterations);
        EXPECT_GT((exact - arch().rest).norm(), edge_length) << "it must have moved";
        for (const BendingJacobian jacobian : {BendingJacobian::constant, BendingJacobian::cubic}) {
            int iterations = 0;
            const Positions other = swung({model, jacobian}, 10, iterations);
            EXPECT_LT((other - exact).cwiseAbs().maxCoeff(), 1e-8 * edge_length);
            EXPECT_GE(iterations, exact_iterations);
        }
    }
}

// The models differ only where triangles are stretched: a sheet that hardly stretches must move alike under
// all of them.
TEST(BendingEnergy, CubicAndNonlinearSheetsMoveAlike) {
    int iterations = 0;
    const Positions nonlinear_path = swung({nonlinear, BendingJacobian::nonlinear}, 40, iterations);
    const double moved = (nonlinear_path - arch().rest).norm();
    EXPECT_GT(moved, 5 * edge_length);
    for (const BendingModel model : {cubic, cubic_2007}) {
        const Positions path = swung({model, BendingJacobian::cubic}, 40, iterations);
        EXPECT_LT((path - nonlinear_path).norm(), 1e-3 * moved);
        EXPECT_GT((path - nonlinear_path).norm(), 0);
    }
}

// With another model than the chosen one a sheet would bend wrongly. Reference: the sum over single hinges.
TEST(BendingEnergy, SumsTheChosenModel) {
    const Shell shell = arch();
    Positions x = shell.rest;
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) += 0.001 * std::sin(static_cast<double>(i * i));
    std::map<BendingModel, double> sums;
    for (const HingeStencil& hinge : shell.hinges) {
        const HingePositions local = columns(x, hinge.vertices);
        const HingePositions rest = columns(shell.rest, hinge.vertices);
        sums[cubic] += value(cubic_hinge(rest, hinge.stiffness), local);
        sums[cubic_2007] += value(cubic_hinge_2007(rest, hinge.stiffness), local);
        sums[nonlinear] += value(nonlinear_hinge(rest, hinge.stiffness), local);
    }
    for (const BendingModel model : {cubic, cubic_2007, nonlinear}) {
        const std::unique_ptr<Energy> energy = bending_energy(shell, {model, exact_jacobian(model)});
        EXPECT_EQ(energy->value(x), sums[model]);
        EXPECT_GT(energy->round_off(), 0);
        EXPECT_LT(energy->round_off(), 1e-12 * energy->value(x)) << "no bound on the round-off but a licence";
        EXPECT_LE(std::abs(energy->value(shell.rest)), energy->round_off());
    }
    EXPECT_NE(sums[cubic], sums[cubic_2007]);
    EXPECT_NE(sums[cubic], sums[nonlinear]);
}

}  // namespace
}  // namespace sherd
