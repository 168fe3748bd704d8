// SPDX-License-Identifier: GPL-3.0-or-later
// Natural frequencies against plate theory. The plain hinge is known to be inexact: its bounds are the
// measured errors plus a margin, and fail when the model gets worse, or better than its documentation claims.
// Coupled hinges converge: their error is mostly due to the lumped mass.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "core/vibration/vibration.h"
#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

/// The `count` slowest modes at rest; checks the number of rigid motions.
Vibration modes_of(const Shell& sheet, BendingModel model, const std::vector<MirrorHinge>& mirrors, int count,
                   Index rigid) {
    Vibration found = vibration(sheet, {.bending = {model}, .mirrors = mirrors}, count);
    EXPECT_EQ(found.rigid, rigid);
    EXPECT_EQ(found.modes.size(), static_cast<std::size_t>(count));
    return found;
}

std::vector<double> percent_errors(const Vibration& measured, const std::vector<double>& theory) {
    std::vector<double> errors;
    for (std::size_t i = 0; i < theory.size(); ++i)
        errors.push_back(100 * (measured.modes.at(i).angular_frequency() / theory[i] - 1));
    return errors;
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
            std::vector<double> percent = percent_errors(modes_of(sheet, model, mirrors, 6, 0), theory);
            test::report(("cantilever strip, modes 1 to 6, b/" + std::to_string(edges) + ", " + name).c_str(),
                         percent);
            return percent;
        };
        const std::vector<double> errors = errors_of(BendingModel::cubic, "cubic");
        for (const int bending_mode : {0, 1, 2, 4, 5})
            EXPECT_NEAR(errors[bending_mode], 0, 16.0 / edges + 1.5) << bending_mode;
        EXPECT_GT(errors[3], 15) << "the twisting mode is known to be stiff: correct docs/theory/bending.md";
        EXPECT_LT(errors[3], 55);
        // The wall keeps the strip from narrowing, which beam theory neglects: frequencies are slightly
        // above it.
        for (const double error : errors_of(BendingModel::coupled, "coupled"))
            EXPECT_NEAR(error, 1, 64.0 / (edges * edges) + 1);
    }
}

/// Compares frequencies, as omega a^2 sqrt(rho t / D), of squares of side 1 whose boundary is pinned or
/// clamped with theory.
void expect_square(bool clamped, const std::vector<double>& theory, double bound_of_coupled,
                   double bound_of_cubic) {
    for (const int edges : {10, 20, 40}) {
        BreakableShell plate = test::flat_plate(1, 1, 1.0 / edges, test::unit_plate(0.3, 0.01));
        Shell& sheet = plate.mechanics();
        const auto at_rim = test::select(sheet, [](const Vector3d& p) {
            return std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()}) < 1e-9;
        });
        std::vector<MirrorHinge> mirrors = test::clamp(sheet, at_rim, sheet.hinges.front().stiffness);
        if (!clamped) mirrors.clear();
        for (const BendingModel model : {BendingModel::cubic, BendingModel::coupled}) {
            const bool coupled = model == BendingModel::coupled;
            const std::vector<double> percent = percent_errors(modes_of(sheet, model, mirrors, 6, 0), theory);
            test::report((std::string(clamped ? "clamped" : "supported") + " square, modes 1 to 6, 1/" +
                          std::to_string(edges) + (coupled ? ", coupled" : ", cubic"))
                             .c_str(),
                         percent);
            const double bound = coupled ? bound_of_coupled : bound_of_cubic;
            for (const double error : percent)
                EXPECT_NEAR(error, 0, bound / (edges * edges) + (coupled ? 0 : 5)) << edges;
        }
    }
}

// Theory: Navier, pi^2 (m^2 + n^2).
TEST(TheoryModes, SupportedSquarePlate) {
    const double unit = std::numbers::pi * std::numbers::pi;
    expect_square(false, {2 * unit, 5 * unit, 5 * unit, 8 * unit, 10 * unit, 10 * unit}, 800, 600);
}

// Theory: Leissa, J. Sound Vib. 31 (1973), 257-293, with the digits of converged Ritz values.
TEST(TheoryModes, ClampedSquarePlate) {
    expect_square(true, {35.985, 73.394, 73.394, 108.217, 131.581, 132.205}, 1600, 800);
}

// Theory of a supported plate with two rigidities, D1 = 1 along x and D2 across, and Poisson's ratio 0:
// omega^2 = pi^4 (m^4 + 2 H m^2 n^2 + D2 n^4), with H = 2 G / Y0.
TEST(TheoryModes, OrthotropicSquarePlate) {
    const double across = 0.2, shear = 0.16;
    Material material = test::unit_plate(0, 0.01);
    material.young1 = across * material.young;
    material.shear = shear * material.young;
    std::vector<double> theory;
    for (const auto& [m, n] : std::vector<std::pair<int, int>>{{1, 1}, {1, 2}, {2, 1}, {1, 3}, {2, 2}})
        theory.push_back(std::numbers::pi * std::numbers::pi *
                         std::sqrt(std::pow(m, 4) + 4 * shear * m * m * n * n + across * std::pow(n, 4)));
    std::sort(theory.begin(), theory.end());
    SheetInput input;
    input.mesh = generate_rectangle(1, 1, {1.0 / 30, Layout::delaunay, 1});
    input.material = material;
    input.axes.assign(input.mesh.number_of_faces(), Vector3d::UnitX());
    BreakableShell plate({input});
    Shell& sheet = plate.mechanics();
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
        const Vector3d p = sheet.rest.col(v);
        sheet.fixed[v] = std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()}) < 1e-9;
    }
    const std::vector<double> percent =
        percent_errors(modes_of(sheet, BendingModel::coupled, {}, 5, 0), theory);
    test::report("orthotropic supported square, modes 1 to 5, 1/30, coupled", percent);
    for (const double error : percent) EXPECT_NEAR(error, 0, 1);
}

// A sheet that is stretched on a frame is a drum: omega^2 = S (pi / a)^2 (m^2 + n^2) / rho, with the second
// Piola-Kirchhoff stress S and the side a at rest; bending adds less than 0.01 %.
TEST(TheoryModes, StretchedMembrane) {
    const double stretch = 1.01, poisson = 0.3, young = 1e6, density = 1000;
    BreakableShell plate = test::flat_plate(1, 1, 1.0 / 30, {density, 1e-4, young, poisson});
    Shell& sheet = plate.mechanics();
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
        const Vector3d p = sheet.rest.col(v);
        sheet.fixed[v] = std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()}) < 1e-9;
    }
    sheet.position *= stretch;
    const double stress = young / (1 - poisson) * (stretch * stretch - 1) / 2;
    std::vector<double> theory;
    for (const int sum : {2, 5, 5, 8, 10, 10})
        theory.push_back(std::numbers::pi * std::sqrt(stress * sum / density));
    const std::vector<double> percent =
        percent_errors(modes_of(sheet, BendingModel::cubic, {}, 6, 0), theory);
    test::report("stretched membrane, modes 1 to 6, 1/30", percent);
    for (const double error : percent) EXPECT_NEAR(error, 0, 1);
}

}  // namespace
}  // namespace sherd
