// SPDX-License-Identifier: GPL-3.0-or-later
// Deflections beside beam and plate theory, of plain hinges and of coupled ones. The bounds are what was
// measured plus a little.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/theory.h"

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

/// Tip deflection of an inextensible cantilever of length 1 and rigidity 1 under the dead load q a length:
/// angle'' = -q (1 - s) cos(angle), angle(0) = 0, angle'(1) = 0, by shooting for angle'(0) with Runge-Kutta's
/// fourth-order method.
struct Elastica {
    double curvature_at_tip, deflection;
};
Elastica shoot(double q, double curvature) {
    using State = Eigen::Vector3d;  // angle, curvature, deflection
    const auto slope = [&](double s, const State& y) {
        return State(y[1], -q * (1 - s) * std::cos(y[0]), std::sin(y[0]));
    };
    State y(0, curvature, 0);
    constexpr int steps = 1000;
    constexpr double h = 1.0 / steps;
    for (int i = 0; i < steps; ++i) {
        const double s = i * h;
        const State a = slope(s, y), b = slope(s + h / 2, y + h / 2 * a), c = slope(s + h / 2, y + h / 2 * b),
                    d = slope(s + h, y + h * c);
        y += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return {y[1], y[2]};
}
double elastica_deflection(double q) {
    double low = 0, high = q;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (shoot(q, middle).curvature_at_tip < 0 ? low : high) = middle;
    }
    return shoot(q, low).deflection;
}

// A strip that bends under its own weight through more than its length's half.
TEST_P(TheoryStatics, HeavyCantilever) {
    const double exact = elastica_deflection(8);
    std::vector<double> errors;
    for (const int edges : {10, 20, 40}) {
        BreakableShell plate = test::flat_plate(1, 0.25, 1.0 / edges, test::unit_plate(0, 0.01));
        Shell& sheet = plate.mechanics();
        StepperOptions options = TheoryStatics::options();
        options.shell.mirrors =
            test::clamp(sheet, test::select(sheet, [](const Vector3d& p) { return p.x() < 1e-9; }),
                        sheet.hinges.front().stiffness);
        options.step = 2;
        options.gravity = Vector3d(0, 0, -8);
        test::settle(sheet, options, 12);
        double tip = 0;
        int count = 0;
        for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
            if (sheet.rest(0, v) > 1 - 1e-9) tip -= sheet.position(2, v), ++count;
        errors.push_back(100 * (tip / count / exact - 1));
        EXPECT_LT(sheet.velocity.cwiseAbs().maxCoeff(), 1e-6) << "has not settled";
    }
    report("heavy cantilever, q L^3 / D = 8, tip", errors);
    for (const double error : errors) EXPECT_NEAR(error, coupled() ? 0 : 4, coupled() ? 1 : 2);
}

/// Deflection of the middle of a simply supported unit square of rigidity 1 under unit pressure (Navier).
double navier() {
    double sum = 0;
    for (int m = 1; m < 200; m += 2)
        for (int n = 1; n < 200; n += 2)
            sum +=
                ((m + n) / 2 % 2 == 0 ? -1 : 1) * 16 / std::pow(pi, 6) / (m * n * std::pow(m * m + n * n, 2));
    return sum;
}

TEST_P(TheoryStatics, SupportedSquareUnderPressure) {
    std::vector<double> errors;
    for (const int edges : {10, 20, 40}) {
        BreakableShell plate = test::flat_plate(1, 1, 1.0 / edges, test::unit_plate(0.3, 0.01));
        Shell& sheet = plate.mechanics();
        const auto rim = test::select(sheet, [](const Vector3d& p) {
            return std::min(p.x(), p.y()) < 1e-9 || std::max(p.x(), p.y()) > 1 - 1e-9;
        });
        for (std::size_t v = 0; v < rim.size(); ++v) sheet.fixed[v] = rim[v];
        StepperOptions options = TheoryStatics::options();
        options.step = 10;
        options.gravity.setZero();
        // So small that the middle surface does not stretch: the theory is linear.
        constexpr double pressure = 1e-3;
        Load load;
        load.pressure = pressure;
        for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
            load.pressed.push_back(static_cast<Index>(t));
        options.shell.loads = {load};
        test::settle(sheet, options, 8);
        // The parabola's value at the middle from the nearest vertices is the largest deflection to 0.1 %.
        errors.push_back(100 * (sheet.position.row(2).maxCoeff() / pressure / navier() - 1));
    }
    report("supported square plate, pressure, middle", errors);
    EXPECT_NEAR(errors[0], coupled() ? 1.4 : -14.7, 2);
    EXPECT_NEAR(errors[1], coupled() ? 0.3 : -11.8, coupled() ? 0.5 : 2);
    EXPECT_NEAR(errors[2], coupled() ? 0.1 : -9.5, coupled() ? 0.2 : 2);
}

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
        // The end moments act where the seam holds both ends together with one tangent.
        StepperOptions options = TheoryStatics::options();
        options.shell.mirrors = test::clamp(
            sheet, test::select(sheet, [](const Vector3d& p) { return std::abs(p.x() - 0.5) > 0.5 - 1e-9; }),
            sheet.hinges.front().stiffness);
        for (MirrorHinge& hinge :
             options.shell.mirrors)  // after the turn the tangent is the same, the place not
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
