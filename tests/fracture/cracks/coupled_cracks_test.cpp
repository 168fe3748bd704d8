// SPDX-License-Identifier: GPL-3.0-or-later
// Coupled hinges and arcs after a crack: only the faces around the crack may be computed again, and the
// result must equal that of a shell that is made with the failed edges open.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <utility>

#include "core/bending/coupled_bending.h"
#include "core/membrane/arc_membrane.h"
#include "core/membrane/membrane_energy.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/generate/generate.h"
#include "tests/support/mesh/random_edges.h"
#include "tests/support/shell/steps.h"
#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

/// A sheet whose rest shape is a quarter of a dome.
BreakableShell dome() {
    SheetInput input;
    input.mesh = generate_rectangle(1, 0.8, {0.12, Layout::delaunay, 2});
    for (const Vertex vertex : input.mesh.vertices()) {
        const Point& p = input.mesh.point(vertex);
        input.mesh.point(vertex) = Point(p.x(), p.y(), 0.5 - 0.4 * p.x() * p.x() - 0.3 * p.y() * p.y());
    }
    input.material = {1000, 0.02, 1e9, 0.3};
    input.strength = uniform_strength(1);
    return BreakableShell({input});
}

std::vector<MirrorHinge> symmetry(const Shell& shell) {
    std::vector<char> on_plane(shell.rest.cols());
    for (Index v = 0; v < shell.rest.cols(); ++v) on_plane[v] = shell.rest(0, v) < 1e-9;
    std::vector<MirrorHinge> hinges;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, on_plane))
        hinges.push_back(symmetry_hinge(shell, side, Vector3d::UnitX(), 1));
    return hinges;
}

using Pairs = std::vector<std::pair<Index, Index>>;

/// The pairs of the energy's pattern, each once, the smaller vertex first.
Pairs pattern_of(const Energy& energy) {
    Pairs pairs;
    energy.add_pattern(pairs);
    for (auto& [i, j] : pairs)
        if (i > j) std::swap(i, j);
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

VectorXd hessian_of(const Energy& energy, const Positions& x) {
    const auto vertices = static_cast<Index>(x.cols());
    BlockMatrix matrix(vertices, pattern_of(energy), std::vector<char>(vertices, 0));
    energy.add_hessian(x, Curvature::exact, matrix);
    return Eigen::Map<const VectorXd>(matrix.values().data(), matrix.values().size());
}

void expect_same(const Energy& followed, const Energy& rebuilt, const Positions& x) {
    const double energy = rebuilt.value(x);
    RC_ASSERT(std::isfinite(energy));
    RC_ASSERT(std::abs(followed.value(x) - energy) <= 1e-12 * energy);
    Positions one = Positions::Zero(3, x.cols()), other = one;
    followed.add_gradient(x, one);
    rebuilt.add_gradient(x, other);
    RC_ASSERT((one - other).norm() <= 1e-12 * other.norm());
    RC_ASSERT(pattern_of(followed) == pattern_of(rebuilt));
    const VectorXd hessian = hessian_of(rebuilt, x);
    RC_ASSERT((hessian_of(followed, x) - hessian).norm() <= 1e-12 * hessian.norm());
}

RC_GTEST_PROP(CoupledCracks, LeaveWhatAShellMadeWithTheseEdgesFreeHas, ()) {
    BreakableShell sheet = dome();
    const Shell& shell = sheet.mechanics();
    const std::vector<MirrorHinge> mirrors = symmetry(shell);
    CoupledBending followed(shell, mirrors);
    ArcMembrane arcs(shell, mirrors);
    const StepContext step = test::step_of(shell, 0, 1e-3);
    pattern_of(followed);  // fills the cache of each face's reach, which has to follow cracks
    for (int batch = 0; batch < 3; ++batch) {
        const test::EdgeRecipe recipe{*rc::gen::inRange(0, test::pattern_count), *rc::gen::inRange(0, 101),
                                      *rc::gen::arbitrary<unsigned>()};
        std::vector<Edge> edges;
        for (const Edge edge : test::random_edges(sheet.mesh(), recipe))
            if (sheet.cracks().state(edge) == EdgeState::interior) edges.push_back(edge);
        if (edges.empty()) continue;
        const ShellChange change = sheet.fail(edges).shell;
        followed.topology_changed(change, step);
        arcs.topology_changed(change, step);

        const CoupledBending rebuilt(shell, mirrors);
        test::Random random(recipe.seed);
        Positions x = shell.rest;
        for (double& coordinate : x.reshaped()) coordinate += random.uniform(-0.02, 0.02);
        expect_same(followed, rebuilt, x);
        expect_same(arcs, ArcMembrane(shell, mirrors), x);
        RC_ASSERT(arcs.value(shell.rest) <= 1e-20 * arcs.value(x));
        RC_ASSERT((followed.curvatures(x) - rebuilt.curvatures(x)).norm() <=
                  1e-12 * rebuilt.curvatures(x).norm());
    }
}

// In pieces one or two triangles wide, hinges have few directions: the energy must stay bounded.
TEST(CoupledCracks, NarrowPiecesStayAsStiffAsTheyWere) {
    BreakableShell sheet = dome();
    const Shell& shell = sheet.mechanics();
    CoupledBending bending(shell, {});
    Positions x = shell.rest;
    for (Index v = 0; v < x.cols(); ++v) x(2, v) += 1e-4 * x(0, v) * x(0, v);
    const double whole = bending.value(x);
    test::Random random(7);
    double most = whole;
    while (!shell.hinges.empty()) {
        const Edge edge(shell.hinge_edge[random.below(shell.hinges.size())]);
        const std::vector<Edge> edges{edge};
        bending.topology_changed(sheet.fail(edges).shell, test::step_of(shell, 0, 1e-3));
        x = shell.rest;
        for (Index v = 0; v < x.cols(); ++v) x(2, v) += 1e-4 * x(0, v) * x(0, v);
        const double energy = bending.value(x);
        EXPECT_TRUE(std::isfinite(energy));
        most = std::max(most, energy);
        if (shell.hinges.size() % 20 == 0)
            std::printf("%zu hinges: %.3f of the whole\n", shell.hinges.size(), energy / whole);
    }
    EXPECT_EQ(bending.value(x), 0) << "without hinges nothing bends";
    EXPECT_LT(most, 1.5 * whole);
}

// When a hinge breaks, the arcs of the sides around it are computed from fewer angles, or none. This must
// not load a sheet without load. Nor may it give a sheet that is bent without stretch more energy than flat
// triangles have; the sheet reaches their energy when all hinges are broken.
TEST(CoupledCracks, ArcsOfABentSheetTurnIntoChordsAtLast) {
    BreakableShell sheet = test::flat_plate(1, 0.8, 0.12, {1000, 0.02, 1e9, 0.3});
    const Shell& shell = sheet.mechanics();
    ArcMembrane arcs(shell, {});
    const MembraneEnergy flat(shell.triangles);
    test::Random random(7);
    double largest = 0, most = 0, before = 0;
    const auto bent = [&] {
        Positions x = shell.rest;
        for (Index v = 0; v < x.cols(); ++v)
            x.col(v) << std::sin(shell.rest(0, v)), shell.rest(1, v), std::cos(shell.rest(0, v)) - 1;
        return x;
    };
    const double chords = flat.value(bent());
    EXPECT_LT(arcs.value(bent()), 1e-3 * chords);
    const std::size_t count = shell.hinges.size();
    while (!shell.hinges.empty()) {
        const std::vector<Edge> edges{Edge(shell.hinge_edge[random.below(shell.hinges.size())])};
        arcs.topology_changed(sheet.fail(edges).shell, test::step_of(shell, 0, 1e-3));
        const double energy = arcs.value(bent());
        largest = std::max(largest, std::abs(energy - std::exchange(before, energy)));
        most = std::max(most, energy);
        EXPECT_LT(arcs.value(shell.rest), 1e-20 * chords);
        if (shell.hinges.size() % 20 == 0)
            std::printf("%3zu of %zu hinges: %.4f of the energy of chords\n", shell.hinges.size(), count,
                        energy / chords);
    }
    std::printf("largest change at a hinge: %.4f, %.2f of a face's share\n", largest / chords,
                largest / chords * static_cast<double>(shell.triangles.size()));
    EXPECT_NEAR(arcs.value(bent()), chords, 1e-10 * chords);
    EXPECT_LT(most, 1.2 * chords);
}

}  // namespace
}  // namespace sherd
