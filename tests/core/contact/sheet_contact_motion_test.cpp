// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "core/contact/sheets/sheet_contact.h"
#include "core/time/implicit_stepper.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

StepperOptions with_contact(double step) {
    StepperOptions options;
    options.step = step;
    options.contact.sheets = true;
    options.tolerance = 1e-8;
    return options;
}

// In one step at 1 km/s the upper plate would end far behind the lower one: it must not pass, but pass on
// its momentum.
TEST(SheetContact, APlateAtAKilometreASecondDoesNotPass) {
    Shell shell = test::stacked_plates(2, 4, 0.05, test::ceramic);
    const Index half = static_cast<Index>(shell.position.cols()) / 2;
    shell.velocity.rightCols(half).row(2).setConstant(-1000);
    StepperOptions options = with_contact(1e-4);
    options.gravity.setZero();
    const Vector3d momentum = linear_momentum(shell);
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < 5; ++i) {
        test::advance(time_step);
        EXPECT_EQ(test::intersections(shell, shell.position), 0);
        EXPECT_GT(test::smallest_distance(shell, shell.position), 0.75 * test::ceramic.thickness);
        EXPECT_GT(shell.position.rightCols(half).row(2).mean(), shell.position.leftCols(half).row(2).mean());
    }
    EXPECT_LT(shell.velocity.leftCols(half).row(2).mean(), -400);
    EXPECT_LT((linear_momentum(shell) - momentum).norm(), 1e-8 * momentum.norm());
}

// A sheet that closes on itself must not intersect itself.
TEST(SheetContact, AFoldingSheetDoesNotPassThroughItself) {
    Shell shell = test::stacked_plates(1, 12, 0, test::thin_rubber);
    for (Index v = 0; v < shell.position.cols(); ++v) {
        const double x = shell.position(0, v);
        shell.velocity.col(v) = Vector3d(-100 * x, 0, 400 * std::abs(x));
    }
    StepperOptions options = with_contact(2e-4);
    options.gravity.setZero();
    ImplicitStepper time_step(shell, options);
    const SheetContact contact(shell);
    std::size_t most = 0;
    for (int i = 0; i < 50; ++i) {
        test::advance(time_step);
        most = std::max(most, contact.active_pairs(shell.position).size());
        EXPECT_EQ(test::intersections(shell, shell.position), 0);
    }
    EXPECT_GT(most, 20u);
}

// A stack must come to rest and stay there, and its lowest plate must carry, to 1 %, the weight of all
// others.
TEST(SheetContact, AStackRestsOnItself) {
    const int plates = 4;
    Shell shell = test::stacked_plates(plates, 4, 1.02 * test::ceramic.thickness, test::ceramic);
    const Index each = static_cast<Index>(shell.position.cols()) / plates;
    std::fill_n(shell.fixed.begin(), each, 1);
    StepperOptions options = with_contact(2e-4);
    options.contact.friction = 0.3;
    options.tolerance = 2e-10;  // m, a hundredth of the plates' overlap
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < 150; ++i) test::advance(time_step);
    const Positions before = shell.position;
    for (int i = 0; i < 50; ++i) test::advance(time_step);
    EXPECT_LT((shell.position - before).cwiseAbs().maxCoeff(), 1e-7);
    Positions forces = Positions::Zero(3, shell.position.cols());
    SheetContact(shell).add_gradient(shell.position, forces);
    const double weight = shell.mass.tail((plates - 1) * each).sum() * 9.81;
    EXPECT_NEAR(forces.leftCols(each).row(2).sum(), weight, 0.01 * weight);
}

/// Cuts the triangle off its sheet: the triangle gets copies of its corners at the same places.
void cut_off(Shell& shell, std::size_t triangle, ImplicitStepper& time_step) {
    ShellChange change;
    for (Index& corner : shell.triangles[triangle].vertices) {
        const Index copy = static_cast<Index>(shell.mass.size());
        const IndexWithParents inserted{copy, {{corner, 1}}};
        follow(shell, {.vertices = {inserted}});
        change.vertices.push_back(inserted);
        for (VectorXd* shared : {&shell.mass, &shell.footprint})
            (*shared)[corner] = (*shared)[copy] = 0.5 * (*shared)[copy];
        shell.exempt_pairs.push_back({corner, copy});
        corner = copy;
    }
    time_step.topology_changed(change);
}

// When a crack opens in the middle of a step, during contact, its coincident crack faces must neither push
// each other nor stop the step, and all else must continue as before.
TEST(SheetContact, ACrackInTheMiddleOfAStepIsBorne) {
    Shell shell = test::stacked_plates(2, 4, 1.1 * test::ceramic.thickness, test::ceramic);
    const Index half = static_cast<Index>(shell.position.cols()) / 2;
    shell.hinges.clear();  // hinges would have to be cut, too
    shell.hinge_edge.clear();
    std::ranges::fill(shell.edge_hinge, -1);
    shell.velocity.rightCols(half).row(2).setConstant(-3);
    StepperOptions options = with_contact(1e-4);
    options.gravity.setZero();
    const Vector3d momentum = linear_momentum(shell);
    ImplicitStepper time_step(shell, options);
    time_step.begin();
    time_step.solve(3);
    EXPECT_GT(SheetContact(shell).active_pairs(time_step.position).size(), 0u);
    cut_off(shell, 50, time_step);
    EXPECT_TRUE(time_step.solve(200));
    time_step.finish();
    for (int i = 0; i < 5; ++i) test::advance(time_step);
    EXPECT_LT((linear_momentum(shell) - momentum).norm(), 1e-8 * momentum.norm());
    EXPECT_GT(test::smallest_distance(shell, shell.position), 0.75 * test::ceramic.thickness);
}

}  // namespace
}  // namespace sherd
