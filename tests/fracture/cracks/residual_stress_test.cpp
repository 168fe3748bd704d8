// SPDX-License-Identifier: GPL-3.0-or-later
// Residual energy of tempered sheets. If it depended on the mesh, or were released twice, tempered glass
// would break into as many fragments as the mesh has faces.
#include "fracture/cracks/residual_stress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double tempering = 1e8;      // Pa
constexpr double square_width = 0.06;  // m

Material tempered_glass() {
    Material material = test::glass;
    material.tempered = tempering;
    return material;
}

SheetInput pane(double edge_length, Layout layout, unsigned seed = 1) {
    SheetInput input;
    input.mesh = generate_rectangle(square_width, square_width, {edge_length, layout, seed});
    input.material = tempered_glass();
    input.strength = uniform_strength(1e9, Measure::stress);
    input.toughness.value = 7.5e5;
    input.toughness.speed_limit = 1500;
    return input;
}

Vertex nearest_vertex(const BreakableShell& shell, const Vector3d& place) {
    Index vertex;
    (shell.mechanics().rest.colwise() - place).colwise().squaredNorm().minCoeff(&vertex);
    return Vertex(static_cast<unsigned>(vertex));
}

/// Edges of a structured pane on the grid line y = height, in the order of x, as far as x = end.
std::vector<Edge> edges_along(const Mesh& mesh, double height, double end) {
    std::vector<std::pair<double, Edge>> found;
    for (const Edge edge : mesh.edges()) {
        const Point a = mesh.point(mesh.vertex(edge, 0)), b = mesh.point(mesh.vertex(edge, 1));
        if (std::abs(a.y() - height) > 1e-9 || std::abs(b.y() - height) > 1e-9 ||
            std::max(a.x(), b.x()) > end)
            continue;
        found.emplace_back(std::min(a.x(), b.x()), edge);
    }
    std::ranges::sort(found);
    std::vector<Edge> edges;
    for (const auto& [x, edge] : found) edges.push_back(edge);
    return edges;
}

TEST(ResidualStress, IsThatOfAParabola) {
    const Material glass = tempered_glass();
    double energy = 0;
    constexpr int layers = 2000;
    for (int i = 0; i < layers; ++i) {
        const double u = (2 * i + 1.0) / layers - 1, stress = 0.5 * tempering * (3 * u * u - 1);
        energy += stress * stress * (1 - glass.poisson) / glass.young * glass.thickness / layers;
    }
    EXPECT_NEAR(residual_stress(glass).energy, energy, 1e-5 * energy);
    EXPECT_EQ(residual_stress(test::glass).energy, 0);
}

TEST(ResidualStress, APieceReleasesTheSameOnAnyMesh) {
    const ResidualStress residual = residual_stress(tempered_glass());
    const double expected = residual.energy * residual.reach;
    for (const double edge_length : {0.0005, 0.001, 0.002, 0.004})
        for (const unsigned seed : {1u, 2u}) {
            const BreakableShell shell({pane(edge_length, Layout::delaunay, seed)});
            const Vertex from = nearest_vertex(shell, {0.025, 0.03, 0});
            const Vector3d to =
                shell.mechanics().rest.col(static_cast<Index>(from)) + Vector3d(edge_length, 0, 0);
            EXPECT_NEAR(residual_release(shell, from, to), expected, 0.01 * expected) << edge_length;
        }
}

// A crack frees a sheet of the stress across it alone, so that a crack perpendicular to it has its full
// release until both meet.
TEST(ResidualStress, ACrackAcrossAnotherReleasesAsMuch) {
    BreakableShell shell({pane(0.001, Layout::structured)});
    const double alone = residual_release(shell, nearest_vertex(shell, {0.03, 0.027, 0}), {0.03, 0.028, 0});
    shell.fail(edges_along(shell.mesh(), 0.03, 1));
    for (const double y : {0.02, 0.027, 0.029}) {
        const Vertex from = nearest_vertex(shell, {0.03, y, 0});
        EXPECT_NEAR(residual_release(shell, from, {0.03, y + 0.0015, 0}), alone, 1e-6 * alone) << y;
    }
}

// No energy is released beyond a rim.
TEST(ResidualStress, ARimIsNoCrackAndEndsTheSheet) {
    const BreakableShell shell({pane(0.001, Layout::structured)});
    const ResidualStress residual = residual_stress(tempered_glass());
    const double beside = 0.001, one_side = 0.5 * residual.energy * residual.reach;
    const Vertex from = nearest_vertex(shell, {0.03, beside, 0});
    EXPECT_NEAR(residual_release(shell, from, {0.031, beside, 0}),
                one_side * (2 - std::exp(-beside / residual.reach)), 0.01 * one_side);
    EXPECT_NEAR(residual_release(shell, from, {0.03, -0.01, 0}), 2 * one_side, 0.02 * one_side)
        << "it runs into the rim";
}

// Less energy is left beside another crack: of the release of one crack face, the share (1 - exp(-s / (2
// reach)))^2 between two cracks at a distance s, and the share 1 - exp(-s / reach) beyond the other crack.
TEST(ResidualStress, ACrackBesideAnotherReleasesLess) {
    const ResidualStress residual = residual_stress(tempered_glass());
    const double edge_length = 0.0005, step = 0.001;
    for (const double gap : {0.0005, 0.001, 0.002}) {
        BreakableShell shell({pane(edge_length, Layout::structured)});
        shell.fail(edges_along(shell.mesh(), 0.03 + gap, 1));
        shell.fail(edges_along(shell.mesh(), 0.03, 0.03 + 1e-9));
        const Vertex from = nearest_vertex(shell, {0.03, 0.03, 0});
        const Vector3d to = shell.mechanics().rest.col(static_cast<Index>(from)) + Vector3d(step, 0, 0);
        const double between = 1 - std::exp(-gap / (2 * residual.reach)),
                     beyond = 1 - std::exp(-gap / residual.reach);
        const double expected = 0.5 * residual.energy * residual.reach * (between * between + beyond);
        EXPECT_NEAR(residual_release(shell, from, to), expected, 0.03 * expected) << gap;
    }
}

TEST(ResidualStress, WhatParallelCracksLeaveDoesNotDependOnTheirOrder) {
    const BreakableShell shell({pane(0.001, Layout::structured)});
    std::vector<Edge> cracks = edges_along(shell.mesh(), 0.03, 0.04);
    for (const Edge edge : edges_along(shell.mesh(), 0.031, 0.05)) cracks.push_back(edge);
    const double whole = residual_energy(shell, {}), left = residual_energy(shell, cracks);
    std::ranges::reverse(cracks);
    EXPECT_NEAR(residual_energy(shell, cracks), left, 1e-9 * whole);
    EXPECT_NEAR(whole, residual_stress(tempered_glass()).energy * square_width * square_width, 1e-9 * whole);
    EXPECT_LT(left, whole);
}

TEST(ResidualStress, ATemperedSurfaceBearsMore) {
    const BreakableShell shell({pane(0.004, Layout::structured)});
    for (const Edge edge : shell.mesh().edges()) {
        if (shell.hinge_of_edge(edge) < 0) continue;
        EXPECT_DOUBLE_EQ(shell.strength(edge), 1.1e9);
    }
}

/// Length of cracks, m, and the last report, of a pane without loads that is tempered by `stress` (Pa),
/// `steps` steps after its rim was notched.
std::pair<double, StepReport> notched(double stress, int steps) {
    SheetInput input = pane(0.002, Layout::structured);
    input.material.tempered = stress;
    SimulationOptions options;
    options.cracks = edges_along(input.mesh, 0.03, 0.004 + 1e-9);
    options.stepper.scheme = Scheme::explicit_differences;
    options.stepper.step = 1e-6;
    options.stepper.gravity.setZero();
    options.stepper.contact.sheets = false;
    Simulation simulation({input}, options);
    StepReport report;
    for (int i = 0; i < steps; ++i) report = simulation.step();
    double length = 0;
    const CrackMesh& cracks = simulation.shell().cracks();
    for (const Edge edge : cracks.mesh().edges()) {
        if (cracks.state(edge) == EdgeState::interior || cracks.is_outline(edge)) continue;
        const Positions& rest = simulation.shell().mechanics().rest;
        const double side = (rest.col(static_cast<Index>(cracks.mesh().vertex(edge, 0))) -
                             rest.col(static_cast<Index>(cracks.mesh().vertex(edge, 1))))
                                .norm();
        length += cracks.mesh().is_border(edge) ? 0.5 * side : side;
    }
    return {length, report};
}

// Only the pane's own residual energy drives the crack: it must propagate where that energy exceeds G_c, and
// only there.
TEST(BreakingResidualStress, DrivesACrackThatItSuffices) {
    const ResidualStress at = residual_stress(tempered_glass());
    const double needed = 7.5e5 * 7.5e5 / test::glass.young,
                 had = at.energy * at.reach / test::glass.thickness;
    const double enough = tempering * std::sqrt(needed / had);
    const auto [none, still] = notched(0.9 * enough, 10);
    EXPECT_NEAR(none, 0.004, 1e-6);
    EXPECT_EQ(still.lost_to_cracks, 0);
    const auto [length, broken] = notched(1.1 * enough, 20);
    EXPECT_GT(length, 0.02);
    EXPECT_GT(broken.lost_to_cracks, needed * test::glass.thickness * (length - 0.004));
    EXPECT_LT(broken.lost_to_cracks, 1.5 * needed * test::glass.thickness * (length - 0.004));
    EXPECT_LT(std::abs(broken.unexplained), 1e-9);
}

// Where residual stress releases more than twice the fracture energy at a crack's speed limit the crack
// branches, and the branches meet.
TEST(BreakingResidualStress, DicesASheetThatHasTooMuch) {
    const auto [length, broken] = notched(2.5e8, 60);
    EXPECT_GT(length, 0.15);
    EXPECT_GT(broken.fragments, 5);
}

}  // namespace
}  // namespace sherd
