// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/time/implicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

// With wrong derivatives Newton's method would not converge, or would find a wrong shape.
TEST(MirrorHinge, GradientAndHessianAreDerivatives) {
    const Shell shell = test::tetrahedron(test::thick_foam);
    // The symmetry plane through vertices 0 and 1 is oblique to the triangle, so that the sheet is folded
    // there at rest.
    const Vector3d along = (shell.rest.col(1) - shell.rest.col(0)).normalized();
    const Vector3d normal = along.cross(Vector3d(0.3, 0.5, -0.4)).normalized();
    const std::vector<MirrorHinge> hinges{symmetry_hinge(shell, {0, 1}, normal, 2),
                                          clamp_hinge(shell, {1, 0}, 3)};
    const MirrorEnergy energy(shell, hinges);
    test::Random random(1);
    Positions x = shell.rest;
    for (double& entry : x.reshaped()) entry += random.uniform(-0.3, 0.3);
    test::expect_derivatives(energy, x, 1e-4, 1e-7);
    Positions force = Positions::Zero(3, 4);
    energy.add_gradient(shell.rest, force);
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 1e-12) << "not in equilibrium at rest";
}

// Half of a sheet at a symmetry plane must move like the whole sheet.
TEST(SymmetryPlane, HalfASheetMovesLikeTheWhole) {
    // A roof: two wings left and right of the ridge x = 0, folded by gravity and a load.
    Positions whole_rest(3, 4), half_rest(3, 3);
    whole_rest << 0, 0, -1, 1, 0, 1, 0.4, 0.4, 0, 0, 0, 0;
    half_rest << 0, 0, 1, 0, 1, 0.4, 0, 0, 0;
    Shell whole = test::small_sheet(whole_rest, {{0, 1, 2}, {0, 3, 1}}, test::thick_foam);
    Shell half = test::small_sheet(half_rest, {{0, 2, 1}}, test::thick_foam);
    half.guides = {Eigen::DiagonalMatrix<double, 3>(0, 1, 1)};
    half.guide = {1, 1, 0};
    StepperOptions options;
    options.gravity = Vector3d(0, 1, -20);
    options.step = 0.01;
    options.tolerance = 1e-13;
    whole.fixed[0] = half.fixed[0] = 1;
    StepperOptions half_options = options;
    half_options.shell.mirrors = {symmetry_hinge(half, {0, 1}, Vector3d::UnitX(), whole.hinges[0].stiffness)};
    ImplicitStepper whole_step(whole, options), half_step(half, half_options);
    for (int i = 0; i < 20; ++i) {
        for (ImplicitStepper* step : {&whole_step, &half_step}) {
            step->begin();
            step->solve(50);
            step->finish();
        }
        EXPECT_EQ(half.position(0, 1), 0.0) << "left the plane";
        EXPECT_LT((half.position.col(2) - whole.position.col(3)).norm(), 1e-9);
        EXPECT_LT((half.position.col(1) - whole.position.col(1)).norm(), 1e-9);
    }
    EXPECT_GT(std::abs(half.position(2, 2)), 0.01) << "nothing moved: the test proves nothing";
}

// With pins alone a sheet that is held along one side would swing freely about this side.
TEST(Clamp, HoldsTheTangent) {
    for (const bool clamped : {false, true}) {
        Positions rest(3, 3);
        rest << 0, 0, 1, 0, 1, 0.5, 0, 0, 0;
        Shell shell = test::small_sheet(rest, {{0, 2, 1}}, {1000, 0.01, 1e9, 0.3});
        shell.fixed = {1, 1, 0};
        StepperOptions options;
        options.step = 0.02;
        if (clamped)
            options.shell.mirrors = {clamp_hinge(shell, {0, 1}, hinge_stiffness({1000, 0.01, 1e9, 0.3}))};
        ImplicitStepper step(shell, options);
        double drop = 0;
        for (int i = 0; i < 100; ++i) {
            step.begin();
            step.solve(50);
            step.finish();
            drop = std::max(drop, -shell.position(2, 2));
        }
        if (clamped)
            EXPECT_LT(drop, 0.5);
        else
            EXPECT_GT(drop, 0.9);
    }
}

}  // namespace
}  // namespace sherd
