// SPDX-License-Identifier: GPL-3.0-or-later
// Energies must not refer to triangles or hinges that are gone, and a run must not gain energy where
// triangles change.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/bending/bending.h"
#include "core/forces/shell_energies.h"
#include "core/membrane/membrane.h"
#include "core/time/stepper.h"
#include "fracture/step/load_locks.h"
#include "tests/support/shell/advanced_sheet.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

Positions shaken(const Positions& rest, unsigned seed) {
    test::Random random(seed);
    Positions x = rest;
    for (double& coordinate : x.reshaped()) coordinate += random.uniform(-0.003, 0.003);
    return x;
}

void expect_same_energy(const Energy& followed, const Energy& anew, const Positions& x) {
    const double energy = anew.value(x);
    RC_ASSERT(std::isfinite(energy));
    RC_ASSERT(std::abs(followed.value(x) - energy) <= 1e-9 * std::abs(energy));
    Positions one = Positions::Zero(3, x.cols()), other = one;
    followed.add_gradient(x, one);
    anew.add_gradient(x, other);
    RC_ASSERT((one - other).norm() <= 1e-9 * other.norm());
    std::vector<std::pair<Index, Index>> pairs, searched_pairs;
    followed.add_pattern(pairs);
    anew.add_pattern(searched_pairs);
    std::ranges::sort(pairs);
    std::ranges::sort(searched_pairs);
    RC_ASSERT(pairs == searched_pairs);
}

std::vector<MirrorHinge> rim_mirrors(const Shell& shell) {
    std::vector<char> all(shell.rest.cols(), 1);
    std::vector<MirrorHinge> mirrors;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, all))
        mirrors.push_back(clamp_hinge(shell, side, 1));
    return mirrors;
}

// An energy that follows changes must equal an energy that is made of the changed shell, and must be zero at
// rest.
RC_GTEST_PROP(AdvanceEnergies, AreThoseOfTheShellAsItIs, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet({test::directed_input(shape, seed)});
    const Shell& shell = sheet.mechanics();
    using enum BendingModel;
    std::vector<std::pair<BendingOptions, std::unique_ptr<Energy>>> all;
    for (const BendingModel model : {coupled, cubic, cubic_2007, nonlinear}) {
        const BendingOptions options{model, exact_jacobian(model)};
        all.emplace_back(options, bending_energy(shell, options));
    }
    const std::unique_ptr<Energy> flat = membrane_energy(shell, MembraneModel::constant_strain),
                                  arcs = membrane_energy(shell, MembraneModel::arc);
    test::Advances advances(sheet, seed + 1);
    const StepContext none;
    const auto follow = [&](const ShellChange& change) {
        for (auto& [options, energy] : all) energy->topology_changed(change, none);
        for (Energy* energy : {flat.get(), arcs.get()}) energy->topology_changed(change, none);
    };
    for (int i = 0; i < 6; ++i) {
        const auto advanced = advances.next();
        if (!advanced) continue;
        follow(advanced->change.shell);
        if (!advances.random_bool()) continue;
        if (const auto change = advances.fail(advanced->halfedge)) follow(change->shell);
    }
    const Positions x = shaken(shell.rest, seed + 3);
    for (const auto& [options, energy] : all) {
        expect_same_energy(*energy, *bending_energy(shell, options), x);
        RC_ASSERT(std::abs(energy->value(shell.rest)) <= energy->round_off() + 1e-9 * energy->value(x));
    }
    expect_same_energy(*flat, *membrane_energy(shell, MembraneModel::constant_strain), x);
    expect_same_energy(*arcs, *membrane_energy(shell, MembraneModel::arc), x);
}

// A clamp whose side is split or gets another triangle must continue to act over its whole length. On a
// curved sheet it keeps its tangent, to which a triangle with another corner is at another angle at rest; so
// energies are compared on flat sheets only.
RC_GTEST_PROP(AdvanceEnergies, ClampsGoOn, ()) {
    const unsigned seed = *rc::gen::inRange(0u, 1u << 30);
    const unsigned shape = *rc::gen::element(0u, 1u, 3u);
    BreakableShell sheet({test::directed_input(shape, seed)});
    const Shell& shell = sheet.mechanics();
    const std::vector<MirrorHinge> mirrors = rim_mirrors(shell);
    const std::unique_ptr<Energy> coupled = bending_energy(shell, {}, mirrors);
    MirrorEnergy single(shell, mirrors);
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 12; ++i)
        if (const auto advanced = advances.next())
            for (Energy* energy : {coupled.get(), static_cast<Energy*>(&single)})
                energy->topology_changed(advanced->change.shell, {});
    const std::vector<MirrorHinge> now = rim_mirrors(shell);
    RC_ASSERT(now.size() == single.all().size());
    const Positions x = shaken(shell.rest, seed + 3);
    const double energy = MirrorEnergy(shell, now).value(x);
    RC_ASSERT(single.value(shell.rest) <= 1e-12 * energy);
    RC_ASSERT(coupled->value(shell.rest) <= 1e-12 * coupled->value(x));
    if (!test::is_flat_sheet(shape)) return;
    RC_ASSERT(std::abs(single.value(x) - energy) <= 1e-9 * energy);
    const double bent = bending_energy(shell, {}, now)->value(x);
    RC_ASSERT(std::abs(coupled->value(x) - bent) <= 1e-9 * bent);
}

// Loads must keep their total force and moment when triangles change.
RC_GTEST_PROP(AdvanceEnergies, LoadsGoOn, ()) {
    const unsigned seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet({test::directed_input(0, seed)});
    const Shell& shell = sheet.mechanics();
    std::vector<Index> faces(shell.triangles.size());
    for (std::size_t f = 0; f < faces.size(); ++f) faces[f] = static_cast<Index>(f);
    const std::vector<char> rim(shell.rest.cols(), 1);
    std::vector<Load> loads(2);
    loads[0].dead = point_forces(shell, std::array<Index, 2>{3, 9}, {1, 2, 3});
    loads[0].spread = area_forces(shell, faces, {0.1, 0, -2});
    loads[0].moments = edge_moments(shell, boundary_triangle_edges(shell, rim), 0.7);
    loads[1].pressed = faces;
    loads[1].pressure = 5;
    lock_load_geometry(sheet, {.loads = loads});
    LoadEnergy energy(shell, loads);
    energy.begin(test::step_of(shell, 0, 1e-3));
    const auto total = [&] {
        Positions force = Positions::Zero(3, shell.rest.cols());
        energy.add_gradient(shell.rest, force);
        Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
        for (Index v = 0; v < force.cols(); ++v) {
            sum.head<3>() += force.col(v);
            sum.tail<3>() += Vector3d(shell.rest.col(v)).cross(Vector3d(force.col(v)));
        }
        return sum;
    };
    const Eigen::Matrix<double, 6, 1> before = total();
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 12; ++i)
        if (const auto advanced = advances.next())
            energy.topology_changed(advanced->change.shell, test::step_of(shell, 0, 1e-3));
    RC_ASSERT((total() - before).norm() <= 1e-10 * before.norm());
}

/// A strip that is pinned at one end, falls and swings, and whose triangles change in every third step.
class AdvancingStrip {
  public:
    AdvancingStrip(Scheme scheme, bool fails, double damping)
        : sheet({input()}), fails(fails), advances(sheet, 4) {
        StepperOptions options;
        options.scheme = scheme;
        options.step = 5e-4;
        options.tolerance = 1e-11;
        options.shell.damping = {damping, 0.5};
        options.shell.loads.resize(1);
        for (Index f = 0; f < static_cast<Index>(sheet.mechanics().triangles.size()); ++f)
            options.shell.loads[0].pressed.push_back(f);
        options.shell.loads[0].pressure = 30;
        stepper = make_stepper(sheet.mechanics(), options);
    }

    void step(int number) {
        ASSERT_TRUE(stepper->begin());
        ASSERT_TRUE(stepper->solve(100));
        largest = std::max(largest, stepper->energies().stored());
        if (number % 3 == 0) {
            if (const auto advanced = advances.next()) {
                changes += !advanced->change.shell.reshaped.empty();
                stepper->topology_changed(advanced->change.shell);
                if (fails)
                    if (const auto change = advances.fail(advanced->halfedge))
                        stepper->topology_changed(change->shell);
            }
            if (stepper->solves_again()) {
                ASSERT_TRUE(stepper->solve(100));
            }
        }
        stepper->finish();
        largest = std::max(largest, kinetic_energy(sheet.mechanics()));
    }

    static SheetInput input() {
        SheetInput input = test::directed_input(0, 8);
        for (const Vertex v : input.mesh.vertices())
            if (input.mesh.point(v).x() < 0.1) input.pinned.push_back(static_cast<Index>(v));
        return input;
    }

    BreakableShell sheet;
    bool fails;
    test::Advances advances;
    std::unique_ptr<Stepper> stepper;
    double largest = 0;
    int changes = 0;
};

TEST(AdvanceEnergies, ABalanceOfEnergyCloses) {
    for (const Scheme scheme : {Scheme::implicit_euler, Scheme::explicit_differences})
        for (const bool fails : {false, true}) {
            AdvancingStrip run(scheme, fails, 1e-5);
            for (int i = 0; i < 60; ++i) run.step(i);
            EXPECT_GT(run.changes, 10);
            const EnergyBalance& balance = run.stepper->balance();
            std::printf("%d %d: lost to cracks and triangles %g, scheme %g, unexplained %g of %g J\n",
                        static_cast<int>(scheme), fails, balance.lost_to_cracks, balance.lost_to_scheme,
                        balance.unexplained, run.largest);
            EXPECT_LT(std::abs(balance.unexplained), 1e-6 * run.largest);
            EXPECT_LT(std::abs(balance.lost_to_cracks), 0.5 * run.largest);
            EXPECT_TRUE(run.sheet.mechanics().position.allFinite());
        }
}

// If a step is discarded after a change of the shell, the change stays, and its energy must be counted once.
TEST(AdvanceEnergies, AStepThatIsBegunAgainCountsOnce) {
    AdvancingStrip run(Scheme::implicit_euler, false, 0);
    for (int i = 1; i < 10; ++i) {
        run.step(1);
        ASSERT_TRUE(run.stepper->begin());
        ASSERT_TRUE(run.stepper->solve(100));
        if (const auto advanced = run.advances.next()) run.stepper->topology_changed(advanced->change.shell);
    }
    run.step(1);
    EXPECT_LT(std::abs(run.stepper->balance().unexplained), 1e-6 * run.largest);
}

// With other triangles an equilibrium may change only by the error of the mesh.
TEST(AdvanceEnergies, StaticsGoOnWithOtherTriangles) {
    BreakableShell sheet({AdvancingStrip::input()});
    StepperOptions options;
    options.scheme = Scheme::statics;
    options.step = 0.1;
    options.arc_length = true;
    options.gravity = {0, 0, -1};
    std::unique_ptr<Stepper> stepper = make_stepper(sheet.mechanics(), options);
    test::Advances advances(sheet, 9);
    double deflection = 0;
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(stepper->begin());
        ASSERT_TRUE(stepper->solve(100));
        const double before = stepper->position.row(2).minCoeff();
        for (int k = 0; k < 3; ++k)
            if (const auto advanced = advances.next()) stepper->topology_changed(advanced->change.shell);
        ASSERT_TRUE(stepper->solve(100));
        deflection = stepper->position.row(2).minCoeff();
        EXPECT_NEAR(deflection, before, 0.2 * std::abs(before));
        stepper->finish();
    }
    EXPECT_LT(deflection, -1e-4);
}

}  // namespace
}  // namespace sherd
