// SPDX-License-Identifier: GPL-3.0-or-later
// Strips cut from an orthotropic sheet at an angle to its first axis. One stiffness for each hinge blurs
// directions, so that the rigidity of strips off the axes is wrong; for single hinges the test requires only
// the trend and the values along both axes. Coupled hinges must follow the theory.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

constexpr double young1 = 0.2, shear = 0.16;  // over Y0; Poisson's ratios are 0

/// Material of rigidity 1 N m along the first axis and 1 kg/m^2.
Material wooden_plate() {
    Material material = test::unit_plate(0, 0.01);
    material.young1 = young1 * material.young;
    material.shear = shear * material.young;
    return material;
}

/// Rigidities of a strip at the angle w, over that of a strip along the first axis.
struct Rigidities {
    double free;      ///< 1 / S11: narrow, free to curl and twist
    double cylinder;  ///< D11: bent to a cylinder
    double paper;     ///< eq. 8 of the paper
};
Rigidities theory(double w) {
    const double c = std::pow(std::cos(w), 2), s = std::pow(std::sin(w), 2), ends = c * c + s * s * young1;
    return {1 / (c * c + s * s / young1 + s * c / shear), ends + 4 * shear * s * c, ends + 2 * shear * s * c};
}

/// Rigidity of a cantilever of length 1 m by the sag q L^4 / (8 rigidity) of its tip under its own weight.
/// The sag is a fraction of the thickness, since this theory is linear.
double measured_rigidity(double w, unsigned seed, BendingModel model = BendingModel::cubic) {
    SheetInput input;
    const double edge_length = model == BendingModel::cubic ? 1.0 / 60 : 1.0 / 40;
    input.mesh = generate_rectangle(1, 0.15, {edge_length, Layout::delaunay, seed});
    input.material = wooden_plate();
    input.axes.assign(input.mesh.number_of_faces(), Vector3d(std::cos(w), std::sin(w), 0));
    BreakableShell plate({input});
    Shell& sheet = plate.mechanics();
    StepperOptions options;
    options.shell.bending = {model, exact_jacobian(model)};
    options.shell.mirrors =
        test::clamp(sheet, test::select(sheet, [](const Vector3d& p) { return p.x() < 1e-9; }),
                    hinge_stiffness(input.material, std::numbers::pi / 2 - w));
    options.step = 20;
    constexpr double weight = 0.004;
    options.gravity = Vector3d(0, 0, -weight);
    test::settle(sheet, options, 8);
    EXPECT_LT(sheet.velocity.cwiseAbs().maxCoeff(), 1e-9) << "has not settled";
    double tip = 0;
    int count = 0;
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
        if (sheet.rest(0, v) > 1 - 1e-9) tip -= sheet.position(2, v), ++count;
    return weight / 8 / (tip / count);
}

// The stiff direction must be along the axis of the input, and the rigidity must fall from there to the soft
// axis.
TEST(TheoryStrips, RigidityFallsFromTheStiffAxisToTheSoftOne) {
    std::printf("strip: angle, measured (mean, least, most of 4 meshes), 1/S11, D11, eq. 8\n");
    std::vector<double> measured;
    for (int angle = 0; angle <= 90; angle += 15) {
        const double w = angle * std::numbers::pi / 180;
        double sum = 0, least = INFINITY, most = 0;
        for (unsigned seed = 1; seed <= 4; ++seed) {
            const double rigidity = measured_rigidity(w, seed);
            sum += rigidity, least = std::min(least, rigidity), most = std::max(most, rigidity);
        }
        measured.push_back(sum / 4);
        const Rigidities exact = theory(w);
        std::printf("strip: %2d  %.3f %.3f %.3f  %.3f %.3f %.3f\n", angle, measured.back(), least, most,
                    exact.free, exact.cylinder, exact.paper);
    }
    for (std::size_t i = 1; i < measured.size(); ++i) EXPECT_LT(measured[i], measured[i - 1]);
    // Single hinges are much too soft along the stiff axis, and a little too stiff along the soft one.
    EXPECT_NEAR(measured.front(), 0.70, 0.04);
    EXPECT_NEAR(measured.back(), 0.225, 0.02);
}

// A strip bends between two theories: its sides are free, but the wall holds its end straight.
TEST(TheoryStrips, CoupledHingesFollowTheTheoryInEveryDirection) {
    for (int angle = 0; angle <= 90; angle += 15) {
        const double w = angle * std::numbers::pi / 180;
        const double measured = measured_rigidity(w, 1, BendingModel::coupled);
        const Rigidities exact = theory(w);
        std::printf("coupled strip: %2d  %.3f  %.3f %.3f\n", angle, measured, exact.free, exact.cylinder);
        EXPECT_GT(measured, 0.985 * exact.free);
        EXPECT_LT(measured, 1.015 * std::max(exact.free, 0.6 * exact.free + 0.4 * exact.cylinder));
    }
}

}  // namespace
}  // namespace sherd
