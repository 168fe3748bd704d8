// SPDX-License-Identifier: GPL-3.0-or-later
// Crack tips are compared with theory, on three meshes of each size. The bounds are the measured errors plus
// a margin; the table is in docs/theory/tips.md.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "core/tips/configurational_force.h"
#include "core/tips/crack_direction.h"
#include "core/tips/stress_intensity.h"
#include "tests/support/shell/cracked_sheet.h"

namespace sherd {
namespace {

constexpr double tip_pi = std::numbers::pi;
const PlaneStress& sheet_at_tips() {
    static const PlaneStress material{test::cracked_material.young, test::cracked_material.poisson};
    return material;
}

/// Values that should be equal, printed as a mean with its deviation.
class Row {
  public:
    Row(std::string what, int size) : what(std::move(what)), size(size) {}
    void add(double value) { values.push_back(value); }
    /// Prints the values, and expects each to be `expected` within `bound`.
    void expect(double expected, double bound) const {
        const auto [mean, deviation] = test::spread(values);
        std::printf("%-34s h/a = 1/%-3d %8.4f +- %.4f\n", what.c_str(), size, mean, deviation);
        for (const double value : values) EXPECT_NEAR(value, expected, bound) << what;
    }

  private:
    std::string what;
    int size;
    std::vector<double> values;
};

std::vector<Row> rows_of_rings(const std::string& what, int size) {
    std::vector<Row> rows;
    for (int rings = 0; rings <= 3; ++rings) rows.emplace_back(what + "J_" + std::to_string(rings), size);
    return rows;
}

using MakeSheet = test::CrackedSheet (*)(double edge_length, unsigned seed);

template <class Visit>
void on_three_meshes(double edge_length, MakeSheet make, Visit visit) {
    for (unsigned seed = 1; seed <= 3; ++seed) visit(make(edge_length, seed));
}

/// Parameter: number of edges along half a crack.
class TheoryTips : public testing::TestWithParam<int> {
  protected:
    static constexpr double stress = 1e-5;  // over Young's modulus
    static constexpr double bend = 1e-5;    // 1/m, across the crack
    static double edge_length() { return 1.0 / GetParam(); }
    template <class Visit>
    static void on_meshes(MakeSheet make, Visit visit) {
        on_three_meshes(edge_length(), make, visit);
    }
    /// sqrt(G / G of theory) of a stretched sheet.
    static double factor(const ConfigurationalForce& force, double half_crack = 1) {
        const double expected =
            membrane_release(sheet_at_tips(), {stress * std::sqrt(tip_pi * half_crack), 0});
        return std::sqrt(force.released() / (test::cracked_material.thickness * expected));
    }
    static double bent_factor(const ConfigurationalForce& force) {
        const double t = test::cracked_material.thickness,
                     expected = plate_release(sheet_at_tips(), {0.5 * t * bend, 0});
        return std::sqrt(force.released() / (t * expected));
    }
};
INSTANTIATE_TEST_SUITE_P(Sizes, TheoryTips, testing::Values(5, 10));
INSTANTIATE_TEST_SUITE_P(LongSizes, TheoryTips, testing::Values(20));

// The release rate of a stretched sheet decides whether a crack propagates.
TEST_P(TheoryTips, StretchedSheetReleasesItsEnergy) {
    std::vector<Row> rows = rows_of_rings("sqrt(G), membrane, ", GetParam());
    on_meshes(test::cracked_sheet, [&](const test::CrackedSheet& sheet) {
        const Positions x = test::stretched(sheet, {0, stress, 0});
        const VertexFaces around(sheet.shell);
        for (const CrackTip& tip : sheet.tips)
            for (int rings = 0; rings <= 3; ++rings)
                rows[rings].add(factor(TipForce(sheet.shell, around, {}, tip, rings).at(x)));
    });
    for (int rings = 0; rings <= 3; ++rings)
        rows[rings].expect(1 - 0.17 / GetParam(), rings == 0 ? 0.04 : 0.012);
}

TEST_P(TheoryTips, BentPlateReleasesItsEnergyAndHasItsFactors) {
    const double nu = test::cracked_material.poisson, k = 0.5 * test::cracked_material.thickness * bend;
    std::vector<Row> rows = rows_of_rings("sqrt(G), bending, ", GetParam());
    Row first("k_1 in bending", GetParam()), second("k_2 / k_1 in bending", GetParam());
    Row turn("degrees in bending", GetParam());
    on_meshes(test::cracked_sheet, [&](const test::CrackedSheet& sheet) {
        const Positions x = test::bent(sheet, 4 * edge_length(), {-nu * bend, bend, 0});
        const VertexFaces around(sheet.shell);
        const CoupledBending bending(sheet.shell, {});
        for (const CrackTip& tip : sheet.tips) {
            for (int rings = 0; rings <= 3; ++rings)
                rows[rings].add(bent_factor(TipForce(sheet.shell, around, {&bending}, tip, rings).at(x)));
            const ModePair found = plate_intensity(sheet.shell, around, bending, tip, x);
            first.add(found.first / k);
            second.add(found.second / found.first);
            turn.add(hoop_direction(sheet_at_tips(), {}, found).angle * 180 / tip_pi);
        }
    });
    for (int rings = 0; rings <= 3; ++rings) rows[rings].expect(1, rings < 2 ? 0.1 : 0.025);
    first.expect(1, 0.05);
    second.expect(0, 0.06);
    turn.expect(0, 4);
}

// Wrong factors would give cracks that are pulled at an angle a wrong direction.
TEST_P(TheoryTips, StretchedSheetHasItsFactorsAndDirections) {
    std::map<int, std::vector<Row>> rows;
    for (const int degrees : {0, 30, 60})
        for (const char* what : {"K_I", "K_II", "degrees from Erdogan and Sih"})
            rows[degrees].emplace_back(what + std::string(" at ") + std::to_string(degrees), GetParam());
    on_meshes(test::cracked_sheet, [&](const test::CrackedSheet& sheet) {
        const VertexFaces around(sheet.shell);
        for (auto& [degrees, of] : rows) {
            const double c = std::cos(degrees * tip_pi / 180), s = std::sin(degrees * tip_pi / 180);
            const Positions x = test::stretched(sheet, stress * Vector3d(s * s, c * c, s * c));
            const double unit = stress * std::sqrt(tip_pi) * c;
            const ModePair exact{unit * c, unit * s};
            for (const CrackTip& tip : sheet.tips) {
                const ModePair found = membrane_intensity(sheet.shell, around, tip, x);
                of[0].add(found.first / exact.first);
                of[1].add(degrees > 0 ? found.second / exact.second : 1 + found.second / exact.first);
                of[2].add((hoop_angle(found) - hoop_angle(exact)) * 180 / tip_pi);
            }
        }
    });
    for (const auto& [degrees, of] : rows) {
        of[0].expect(1, 0.02);
        of[1].expect(1, 0.025);
        of[2].expect(0, 3);
    }
}

// Along whatever edges the crack runs, its release rate must not depend on the number of rings, and be that
// of a straight crack between the same tips.
TEST_P(TheoryTips, ZigzagCrackReleasesWhatAStraightOneDoes) {
    std::vector<Row> rows = rows_of_rings("sqrt(G), zigzag, ", GetParam());
    Row intensity("K_I, zigzag", GetParam());
    on_meshes(test::zigzag_sheet, [&](const test::CrackedSheet& sheet) {
        const Positions x = test::stretched(sheet, {0, stress, 0});
        const VertexFaces around(sheet.shell);
        const double half =
            0.5 *
            (sheet.shell.rest.col(sheet.tips[1].vertex) - sheet.shell.rest.col(sheet.tips[0].vertex)).norm();
        for (const CrackTip& tip : sheet.tips) {
            for (int rings = 0; rings <= 3; ++rings)
                rows[rings].add(factor(TipForce(sheet.shell, around, {}, tip, rings).at(x), half));
            intensity.add(membrane_intensity(sheet.shell, around, tip, x).first /
                          (stress * std::sqrt(tip_pi * half)));
        }
    });
    for (int rings = 0; rings <= 3; ++rings) rows[rings].expect(1, 0.1);
    intensity.expect(1, 0.5);
}

/// Sheet that is open from its left side to its centre.
test::CrackedSheet half_slit_sheet(double edge_length, unsigned seed) {
    return test::slit_sheet(edge_length, seed, {-test::half_width, 0});
}

// An infinite plate with an open crack does not have the second mode of plates: here the displacements of
// the outline prescribe both modes.
TEST(TheoryTipsOfOutlines, PlateHasTheFactorsOfItsOutline) {
    constexpr int size = 5;  // edges per m; the only other length is the distance to the outline, 6 m
    constexpr double edge_length = 1.0 / size;
    const double t = test::cracked_material.thickness, unit = 1e-5 * t;
    for (const auto& [first, second] : {std::pair(1, 0), {0, 1}, {1, 1}}) {
        const ModePair exact{first * unit, second * unit};
        const std::string of = " of (" + std::to_string(first) + ", " + std::to_string(second) + ")";
        Row release("sqrt(G)" + of, size), k_1("k_1" + of, size), k_2("k_2" + of, size);
        on_three_meshes(edge_length, half_slit_sheet, [&](const test::CrackedSheet& sheet) {
            CoupledBending bending(sheet.shell, {});
            const Positions x = test::equilibrium(
                sheet.shell, test::near_outline(sheet.shell, 4 * edge_length), Vector3d(0, 0, 1).asDiagonal(),
                {&bending}, [&](const Vector2d& at) {
                    return Vector3d(
                        0, 0, test::tip_deflection(at, sheet.material.poisson, t, exact.first, exact.second));
                });
            const VertexFaces around(sheet.shell);
            const CrackTip& tip = sheet.tips.front();
            const double released = TipForce(sheet.shell, around, {&bending}, tip).at(x).bending.x();
            release.add(std::sqrt(released / (t * plate_release(sheet_at_tips(), exact))));
            const ModePair found = plate_intensity(sheet.shell, around, bending, tip, x);
            k_1.add(found.first / unit);
            k_2.add(found.second / unit);
        });
        release.expect(1, 0.03);
        k_1.expect(first, 0.07);
        k_2.expect(second, 0.07);
    }
}

}  // namespace
}  // namespace sherd
