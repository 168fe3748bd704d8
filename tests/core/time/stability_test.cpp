// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/stability.h"

#include <gtest/gtest.h>

#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

/// Two triangles that meet in a folded hinge, with an edge of 1 m between them.
Shell fold(double thickness) {
    const Material material{1000, thickness, 1e9, 0.3};
    Shell shell;
    resize_vertices(shell, 4);
    shell.rest = shell.position = test::folded_hinge(1.0, 0.2, 0.9, 0.7, 0.8);
    shell.mass.setConstant(1000 * thickness);
    for (const std::array<Index, 3>& triangle : {std::array{0, 1, 2}, std::array{0, 3, 1}})
        shell.triangles.push_back(
            {triangle, membrane_triangle(columns(shell.rest, triangle), membrane_elasticity(material))});
    shell.hinges.push_back(hinge_stencil(shell, {0, 1, 2, 3}, hinge_stiffness(material)));
    return shell;
}

// The user must be warned of a scene that is unstable at rest.
TEST(Stability, HoldsForThinSheetsOnly) {
    EXPECT_TRUE(stable_at_rest(fold(0.01)));
    EXPECT_TRUE(stable_at_rest(fold(0.3)));
    EXPECT_FALSE(stable_at_rest(fold(30)));
}

// The nonlinear hinge has its least energy at rest, whatever the membrane does.
TEST(Stability, OfTheNonlinearHingeHoldsAlways) {
    EXPECT_TRUE(stable_at_rest(fold(30), BendingModel::nonlinear));
}

/// Smallest eigenvalue of the stiffness at rest, N/m, with the inertia of a step of 0.1 s.
double smallest_stiffness(const Shell& shell) {
    Eigen::MatrixXd stiffness =
        test::hessian_of(*bending_energy(shell, {BendingModel::cubic, BendingJacobian::cubic}), shell.rest,
                         Curvature::exact) +
        test::hessian_of(*membrane_energy(shell, MembraneModel::constant_strain), shell.rest,
                         Curvature::exact);
    for (Index i = 0; i < stiffness.rows(); ++i) stiffness(i, i) += 100 * shell.mass[i / 3];
    return test::eigenvalues(stiffness)[0];
}

// Most sheets are proved stable hinge by hinge, without the matrix of the whole sheet; no unstable sheet may
// be called stable.
TEST(Stability, OfCubicHingesIsThatOfTheWholeMatrix) {
    int stable = 0, unstable = 0;
    for (double factor = 1; factor < 1e8; factor *= 3) {
        Shell shell = test::curved_patch();
        for (HingeStencil& hinge : shell.hinges) hinge.stiffness *= factor;
        const bool holds = smallest_stiffness(shell) > 0;
        EXPECT_EQ(stable_at_rest(shell), holds) << factor;
        ++(holds ? stable : unstable);
    }
    EXPECT_GT(stable, 2);
    EXPECT_GT(unstable, 2);
}

// With arcs the rest shape is the same, and the membrane must still outweigh the negative stiffness of cubic
// hinges.
TEST(Stability, IsEvaluatedWithTheMembraneThatIsChosen) {
    Shell shell = test::curved_patch();
    EXPECT_TRUE(stable_at_rest(shell, BendingModel::coupled, MembraneModel::arc));
    EXPECT_TRUE(stable_at_rest(shell, BendingModel::cubic, MembraneModel::arc));
    for (HingeStencil& hinge : shell.hinges) hinge.stiffness *= 1e8;
    EXPECT_FALSE(stable_at_rest(shell, BendingModel::cubic, MembraneModel::arc));
}

// The Hessian of the form of 2007 at rest is indefinite wherever the sheet is curved, and does not tell
// where the sheet settles: the answer must be that for the corrected hinge.
TEST(Stability, OfTheFormOf2007IsThatOfTheCubicHinge) {
    EXPECT_TRUE(stable_at_rest(fold(0.3), BendingModel::cubic_2007));
    EXPECT_FALSE(stable_at_rest(fold(30), BendingModel::cubic_2007));
}

}  // namespace
}  // namespace sherd
