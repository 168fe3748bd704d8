// SPDX-License-Identifier: GPL-3.0-or-later
// Crack tips with loads in their rings, and in curved shells.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/forces/loads.h"
#include "core/tips/configurational_force.h"
#include "core/tips/near_tip_fields.h"
#include "tests/support/shell/cracked_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

constexpr double load_of_tips = 1e-5;  // Pa, of a sheet with Young's modulus 1 Pa

Positions forces_of(const Energy& loads, const Positions& x) {
    Positions gradient = Positions::Zero(3, x.cols());
    loads.add_gradient(x, gradient);
    return -gradient;
}

/// Load that pushes the crack faces (lips) from -1 to 1 apart by a pressure on them.
Load pressure_on_crack_faces(const test::CrackedSheet& sheet, double pressure) {
    const std::vector<char> crack_faces = [&] {
        std::vector<char> all(sheet.shell.rest.cols());
        for (Index v = 0; v < sheet.shell.rest.cols(); ++v)
            all[v] = std::abs(sheet.shell.rest(1, v)) < 1e-9 && std::abs(sheet.shell.rest(0, v)) < 1 + 1e-9;
        return all;
    }();
    std::array<std::vector<TriangleEdge>, 2> sides;  // below the crack, and above
    for (const TriangleEdge& side : boundary_triangle_edges(sheet.shell, crack_faces))
        sides[sheet.shell.rest(1, edge_and_apex(sheet.shell, side)[2]) > 0].push_back(side);
    Load load;
    for (const int above : {0, 1}) {
        const Vector3d force(0, (above ? 1 : -1) * pressure * sheet.material.thickness, 0);
        const std::vector<CornerForce> more = line_forces(sheet.shell, sides[above], force);
        load.dead.insert(load.dead.end(), more.begin(), more.end());
    }
    return load;
}

// Pressure on the crack faces must release as much as a pull on the sheet: both loads differ by a uniform
// stress, which needs no crack. The pressure acts within the moving rings and must count there.
TEST(LoadedTips, PressureOnCrackFacesReleasesWhatAPullDoes) {
    for (const int size : {5, 10}) {
        std::array<double, 3> with{}, without{};
        for (unsigned seed = 1; seed <= 3; ++seed) {
            const test::CrackedSheet sheet = test::cracked_sheet(1.0 / size, seed);
            MembraneEnergy membrane(sheet.shell.triangles);
            LoadEnergy loads(sheet.shell, {pressure_on_crack_faces(sheet, load_of_tips)});
            loads.begin(test::step_of(sheet.shell, 0, 1));
            const double nu = sheet.material.poisson;
            const Positions x = test::equilibrium(
                sheet.shell, test::near_outline(sheet.shell, 1e-9), Vector3d(1, 1, 0).asDiagonal(),
                {&membrane, &loads}, [&](const Vector2d& at) {
                    const Vector2d pulled = test::crack_displacement(at, 1, nu, {0, load_of_tips, 0});
                    return Vector3d(pulled.x() + nu * load_of_tips * at.x(),
                                    pulled.y() - load_of_tips * at.y(), 0);
                });
            const double expected = sheet.material.thickness * std::numbers::pi * load_of_tips * load_of_tips;
            const VertexFaces around(sheet.shell);
            const Positions pulled = test::stretched(sheet, {0, load_of_tips, 0});
            for (const CrackTip& tip : sheet.tips)
                for (int rings = 0; rings < 3; ++rings) {
                    const TipForce force(sheet.shell, around, {}, tip, rings);
                    const double pressed = force.at(x, {.on_crack_faces = forces_of(loads, x)}).sum().norm();
                    EXPECT_NEAR(pressed / force.at(pulled).sum().norm(), 1, 1e-3);
                    with[rings] += pressed / expected / 6;
                    without[rings] += force.at(x).sum().norm() / expected / 6;
                }
        }
        std::printf("G, pressure on lips, h/a = 1/%-3d", size);
        for (int rings = 0; rings < 3; ++rings)
            std::printf("  J_%d %.3f, without loads %.3f", rings, with[rings], without[rings]);
        std::printf("\n");
        EXPECT_LT(without[2], 0.3);
    }
}

/// Sheet rolled to a shell of radius `radius` about the x axis.
test::CrackedSheet rolled_sheet(double edge_length, unsigned seed, double radius, double thickness) {
    Mesh mesh = test::square_mesh(edge_length, seed, {{{-1, 0}, {1, 0}}});
    for (const Vertex v : mesh.vertices()) {
        const Point at = mesh.point(v);
        mesh.point(v) = Point(at.x(), radius * std::sin(at.y() / radius), radius * std::cos(at.y() / radius));
    }
    Material material = test::cracked_material;
    material.thickness = thickness;
    test::CrackedSheet sheet{test::sheet_of(mesh, material).mechanics(), {}, material};
    sheet.tips = test::tips_at(sheet.shell, {{-1, 0, radius}, {1, 0, radius}});
    return sheet;
}

/// Positions of the cylinder under pressure, with the stress load_of_tips around the cylinder and none along
/// it.
Positions blown_up(const test::CrackedSheet& sheet, double radius, LoadEnergy& loads) {
    const auto angle_at = [&](Index v) { return std::atan2(sheet.shell.rest(1, v), sheet.shell.rest(2, v)); };
    std::vector<char> outline = test::near_outline(sheet.shell, 1e-9);
    for (Index v = 0; v < sheet.shell.rest.cols(); ++v)
        outline[v] = std::abs(sheet.shell.rest(0, v)) > test::half_width - 1e-9 ||
                     std::abs(radius * angle_at(v)) > test::half_width - 1e-9;
    MembraneEnergy membrane(sheet.shell.triangles);
    CoupledBending bending(sheet.shell, {});
    loads.begin(test::step_of(sheet.shell, 0, 1));
    return test::equilibrium(
        sheet.shell, outline, Matrix3d::Identity(), {&membrane, &bending, &loads}, [&](Index v) {
            const double angle = angle_at(v);
            const Vector2d at(sheet.shell.rest(0, v), radius * angle);
            const Vector2d flat =
                test::crack_displacement(at, 1, sheet.material.poisson, {0, load_of_tips, 0});
            const double around = flat.y() - load_of_tips * at.y();
            return Vector3d(flat.x(), around * std::cos(angle) + load_of_tips * radius * std::sin(angle),
                            -around * std::sin(angle) + load_of_tips * radius * std::cos(angle));
        });
}

// A thin sheet that is rolled up by 2 rad across its crack is far from small displacements, where no theory
// gives the release; still the release must not depend on the number of moving rings.
TEST(LoadedTips, RollingUpReleasesTheSameWithAnyRings) {
    constexpr double radius = 6;
    const test::CrackedSheet sheet = test::cracked_sheet(0.1, 1);
    MembraneEnergy membrane(sheet.shell.triangles);
    CoupledBending bending(sheet.shell, {});
    Shell shell = sheet.shell;
    shell.fixed = test::near_outline(shell, 0.4);
    Positions x = shell.rest;
    for (Index v = 0; v < x.cols(); ++v) {
        const double angle = shell.rest(1, v) / radius;
        x.col(v).tail<2>() << radius * std::sin(angle), radius * (1 - std::cos(angle));
    }
    TimeSpent spent;
    Potential potential(shell, {&membrane, &bending}, spent);
    EXPECT_TRUE(Newton(1e-11).minimise(potential, 200, x).converged);
    const VertexFaces around(shell);
    for (const CrackTip& tip : sheet.tips) {
        std::vector<ConfigurationalForce> forces;
        for (int rings = 0; rings <= 4; ++rings)
            forces.push_back(TipForce(shell, around, {&bending}, tip, rings).at(x));
        std::printf("J of a sheet rolled up, over that of 2 rings:");
        for (const ConfigurationalForce& force : forces) {
            std::printf("  J_%d %.3f (membrane %.3f)", force.rings, force.sum().x() / forces[2].sum().x(),
                        force.membrane.x() / forces[2].sum().x());
            const double bound = force.rings == 0 ? 0.1 : 0.04;
            EXPECT_NEAR(force.sum().x() / forces[2].sum().x(), 1, bound);
        }
        std::printf("\n");
    }
}

// Curvature makes a crack along a pressurised cylinder bulge, which releases more than in a flat sheet, by
//     1 + 1.255 a^2 / (R t) - 0.0135 (a^2 / (R t))^2
// (Folias, An axial crack in a pressurized cylindrical shell, 1965, as Kiefner and others fitted it, 1973).
TEST(LoadedTips, CrackAlongAPressurisedCylinder) {
    constexpr int size = 10;
    for (const double squared : {1.0, 4.0}) {
        const double radius = 10, thickness = 1 / (radius * squared);
        const test::CrackedSheet sheet = rolled_sheet(1.0 / size, 1, radius, thickness);
        Load pressed;
        pressed.pressure = load_of_tips * thickness / radius;
        for (Index face = 0; face < static_cast<Index>(sheet.shell.triangles.size()); ++face)
            pressed.pressed.push_back(face);
        LoadEnergy loads(sheet.shell, {pressed});
        const Positions x = blown_up(sheet, radius, loads);
        const double flat = thickness * std::numbers::pi * load_of_tips * load_of_tips;
        const double expected = 1 + 1.255 * squared - 0.0135 * squared * squared;
        const VertexFaces around(sheet.shell);
        const CoupledBending bending(sheet.shell, {});
        for (const CrackTip& tip : sheet.tips) {
            std::printf("G, cylinder, a^2/(R t) = %.0f, theory %.2f:", squared, expected);
            for (int rings = 0; rings <= 4; ++rings) {
                const ConfigurationalForce force = TipForce(sheet.shell, around, {&bending}, tip, rings)
                                                       .at(x, {.spread = forces_of(loads, x)});
                std::printf("  J_%d %.3f (bending %.3f, loads %.3f)", rings, force.sum().norm() / flat,
                            force.bending.x() / flat, force.loads.x() / flat);
                EXPECT_NEAR(force.sum().norm() / flat, expected, (rings == 0 ? 0.3 : 0.1) * expected);
            }
            std::printf("\n");
        }
    }
}

}  // namespace
}  // namespace sherd
