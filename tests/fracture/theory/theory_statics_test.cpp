// SPDX-License-Identifier: GPL-3.0-or-later
// End moments are compared with beam theory, with plain and coupled hinges. The bounds are the measured
// errors plus a margin. Deflections are cases of `sherd-bench shells`.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

constexpr double pi = std::numbers::pi;

class TheoryStatics : public testing::TestWithParam<BendingModel> {
  protected:
    static bool coupled() { return GetParam() == BendingModel::coupled; }
    static StepperOptions options() {
        StepperOptions options;
        options.shell.bending = {GetParam(), exact_jacobian(GetParam())};
        return options;
    }
    static void report(const std::string& what, const std::vector<double>& percent) {
        test::report((what + (coupled() ? ", coupled" : ", cubic")).c_str(), percent);
    }
};
INSTANTIATE_TEST_SUITE_P(Models, TheoryStatics, testing::Values(BendingModel::cubic, BendingModel::coupled));

// The couple that keeps a strip of rigidity 1 and width 0.25 in a circle of circumference 1 is D b 2 pi / L,
// and by Clapeyron's theorem half of its work over the turn 2 pi is the strip's energy.
TEST_P(TheoryStatics, StripRolledByEndMomentsIntoACircle) {
    constexpr double width = 0.25;
    std::vector<double> errors;
    for (const int edges : {10, 20, 40}) {
        BreakableShell plate = test::flat_plate(1, width, 1.0 / edges, test::unit_plate(0, 0.01));
        Shell& sheet = plate.mechanics();
        for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
            const double angle = 2 * pi * sheet.rest(0, v), radius = 1 / (2 * pi);
            sheet.position.col(v) << radius * std::sin(angle), sheet.rest(1, v),
                radius * (1 - std::cos(angle));
        }
        // Both ends, which meet in the circle, are clamped with one tangent, and the couples of these clamps
        // are the end moments.
        StepperOptions options = TheoryStatics::options();
        options.shell.mirrors = test::clamp(
            sheet, test::select(sheet, [](const Vector3d& p) { return std::abs(p.x() - 0.5) > 0.5 - 1e-9; }),
            sheet.hinges.front().stiffness);
        for (MirrorHinge& hinge :
             options.shell.mirrors)  // a full turn leaves the tangents of the ends, and moves their places
            hinge.offset =
                hinge.normal.dot(Vector3d(sheet.position.col(edge_and_apex(sheet, hinge.side)[0])));
        options.step = 2;
        options.gravity.setZero();
        test::settle(sheet, options, 12);
        EXPECT_LT(sheet.velocity.cwiseAbs().maxCoeff(), 1e-6) << "has not settled";
        double diameter = 0;
        for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
            diameter = std::max(diameter, sheet.position(2, v));
        EXPECT_NEAR(diameter * pi, 1, 0.03);
        const double energy = ShellEnergies(sheet, options.shell).bending_value(sheet.position);
        const double couple = energy / pi;
        errors.push_back(100 * (couple / (width * 2 * pi) - 1));
    }
    report("strip rolled into a circle, end moment", errors);
    for (const double error : errors) EXPECT_NEAR(error, 0, coupled() ? 2 : 15);
}

}  // namespace
}  // namespace sherd
