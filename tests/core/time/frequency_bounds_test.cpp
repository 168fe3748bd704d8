// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds on frequencies limit explicit substeps: below the true frequencies, vibrations would grow without
// bound; far above, runs would be slow.
#include "core/time/frequency_bounds.h"

#include <gtest/gtest.h>

#include "core/forces/shell_energies.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/elastic_gradient.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

/// The highest squared frequency, 1/s^2, of the shell at x without fixed vertices, by differences of forces.
double highest_square(const Shell& shell, ShellEnergies& energies, const Positions& x) {
    const double trial = 1e-8;
    Eigen::MatrixXd stiffness(x.size(), x.size());
    for (Index i = 0; i < static_cast<Index>(x.size()); ++i) {
        Positions ahead = x, behind = x;
        ahead.reshaped()[i] += trial;
        behind.reshaped()[i] -= trial;
        stiffness.col(i) =
            (test::elastic_gradient(energies, ahead) - test::elastic_gradient(energies, behind)).reshaped() /
            (2 * trial);
    }
    for (Index v = 0; v < static_cast<Index>(shell.fixed.size()); ++v)
        if (shell.fixed[v]) {
            stiffness.middleRows<3>(3 * v).setZero();
            stiffness.middleCols<3>(3 * v).setZero();
        }
    const VectorXd mass = shell.mass.replicate(1, 3).transpose().reshaped();
    return test::modes_of(0.5 * (stiffness + stiffness.transpose()), mass).squares.maxCoeff();
}

TEST(FrequencyBounds, ExceedTheHighestFrequencyByLittle) {
    for (const BendingModel model : {BendingModel::coupled, BendingModel::cubic, BendingModel::nonlinear})
        for (const bool held : {false, true}) {
            Shell shell = test::stacked_plates(1, 5, 0, test::glass);
            if (held) std::fill(shell.fixed.begin(), shell.fixed.begin() + 12, char(1));
            ShellEnergies energies(shell, {.bending = {model, exact_jacobian(model)}});
            // Bent to a radius of 0.1 m, and shaken.
            Positions x = test::shaken(shell, 1e-4, 5);
            x.row(2) += 5 * shell.rest.row(0).cwiseAbs2();
            FrequencyBounds bounds;
            bounds.find(energies.elastic(), shell, x);
            const double highest = highest_square(shell, energies, x);
            EXPECT_GE(bounds.squares().maxCoeff(), highest);
            EXPECT_LT(bounds.squares().maxCoeff(), 1.3 * 1.3 * highest);
            EXPECT_EQ(bounds.squares()[3] == 0, held);
        }
}

// After a crack only bounds near it are computed again. If the neighbourhood were too small, vertices with
// new neighbours would keep the bounds of the whole sheet.
TEST(FrequencyBounds, FollowAnEdgeThatOpens) {
    for (const BendingModel model : {BendingModel::coupled, BendingModel::cubic}) {
        Shell shell = test::stacked_plates(1, 16, 0, test::glass);
        ShellEnergies energies(shell, {.bending = {model}});
        const Positions x = test::shaken(shell, 1e-5, 5);
        FrequencyBounds bounds;
        bounds.find(energies.elastic(), shell, x);
        const VectorXd before = bounds.squares();
        for (const Index hinge : {400, 120}) {
            ShellChange change;
            const Index edge = shell.hinge_edge[hinge];
            remove_hinge_of(shell, edge);
            change.removed_hinges = {hinge};
            for (Energy* energy : energies.elastic()) energy->topology_changed(change, {});
            bounds.follow(energies.elastic(), shell, x);
            FrequencyBounds anew;
            anew.find(energies.elastic(), shell, x);
            EXPECT_GT((before - anew.squares()).norm(), 1e-6 * before.norm());
            EXPECT_LT((bounds.squares() - anew.squares()).cwiseAbs().maxCoeff(), 1e-12 * before.maxCoeff());
        }
    }
}

// A vertex that becomes lighter vibrates faster, though its faces stay.
TEST(FrequencyBounds, FollowTheMass) {
    Shell shell = test::stacked_plates(2, 5, 0.1, test::glass);
    ShellEnergies energies(shell, {});
    FrequencyBounds bounds;
    bounds.find(energies.elastic(), shell, shell.position);
    const double before = bounds.squares()[50];
    shell.mass[50] *= 0.25;
    bounds.follow(energies.elastic(), shell, shell.position);
    EXPECT_NEAR(bounds.squares()[50], 4 * before, 1e-9 * before);
    const auto& fastest = shell.triangles[*bounds.fastest_triangle()].vertices;
    EXPECT_NE(std::ranges::find(fastest, 50), fastest.end());
}

}  // namespace
}  // namespace sherd
