// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic forces are computed for several elements at once, in batches. A batch must have the gradient of
// the energies that it replaces.
#include "core/batches/elastic_gradient.h"

#include <gtest/gtest.h>

#include "core/batches/elastic_energy.h"
#include "tests/support/shell/elastic_gradient.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

const ShellEnergyOptions all_models[] = {
    {.bending = {BendingModel::coupled}},
    {.bending = {BendingModel::cubic}},
    {.bending = {BendingModel::cubic, BendingJacobian::cubic}},
    {.bending = {BendingModel::cubic_2007}},
    {.bending = {BendingModel::nonlinear}},
    {.bending = {BendingModel::coupled}, .membrane = MembraneModel::arc},
    {.bending = {BendingModel::cubic}, .membrane = MembraneModel::arc},
    {.bending = {BendingModel::coupled}, .yields = {1e5}},
};

Shell curved_sheet() {
    Shell shell = test::curved_patch();
    shell.face_sheet.assign(shell.triangles.size(), 0);
    return shell;
}

void expect_same(const Shell& shell, const ShellEnergyOptions& options, double amplitude) {
    ShellEnergies energies(shell, options);
    const Threads threads;
    ElasticGradient batches(shell, energies, options, threads);
    const Positions x = test::shaken(shell, amplitude, 5), expected = test::elastic_gradient(energies, x);
    EXPECT_LT((batches.at(x) - expected).norm(), 1e-12 * expected.norm())
        << "model " << static_cast<int>(options.bending.model) << ", " << options.mirrors.size()
        << " mirrors";
}

// A wrong formula in a batch would move sheets wrongly. Sheets are flat and curved, angles small and large,
// with and without mirrors.
TEST(ElasticGradient, IsThatOfTheEnergiesWithEachModel) {
    Shell flat = test::flat_patch(), curved = curved_sheet();
    flat.face_sheet.assign(flat.triangles.size(), 0);
    for (Shell* shell : {&flat, &curved})
        for (ShellEnergyOptions options : all_models)
            for (const double amplitude : {0.001, 0.03, 0.3}) {
                expect_same(*shell, options, amplitude);
                options.mirrors = test::patch_mirrors(*shell);
                expect_same(*shell, options, amplitude);
                options.mirrors.clear();
            }
}

// The balance of energy takes the energies of the batches: they must be those of the forces.
TEST(ElasticGradient, HasTheEnergiesOfTheModels) {
    int known = 0;
    Shell shell = curved_sheet();
    for (ShellEnergyOptions options : all_models)
        for (const bool mirrored : {false, true}) {
            if (mirrored) options.mirrors = test::patch_mirrors(shell);
            const ShellEnergies energies(shell, options);
            ElasticGradient batches(shell, energies, options, Threads());
            EXPECT_FALSE(batches.energies());
            const Positions x = test::shaken(shell, 0.03, 5);
            batches.find(x);
            const auto found = batches.energies();
            if (!found) continue;
            ++known;
            EXPECT_NEAR(found->bending / energies.bending_value(x), 1, 1e-12);
            EXPECT_NEAR(found->membrane / energies.membrane_value(x), 1, 1e-12);
            batches.move(3, x.col(3));
            EXPECT_FALSE(batches.energies());
        }
    EXPECT_EQ(known, 2) << "coupled hinges, with and without mirrors";
}

// Local steps compute forces again near a few vertices. An element that was left out would keep its old
// force.
TEST(ElasticGradient, IsFoundAgainWhereVerticesHaveMoved) {
    Shell flat = test::flat_patch(), curved = curved_sheet();
    flat.face_sheet.assign(flat.triangles.size(), 0);
    for (Shell* shell : {&flat, &curved})
        for (ShellEnergyOptions options : all_models)
            for (const bool mirrored : {false, true}) {
                if (mirrored) options.mirrors = test::patch_mirrors(*shell);
                ShellEnergies energies(*shell, options);
                ElasticGradient batches(*shell, energies, options, Threads());
                if (!batches.is_local()) continue;
                std::vector<Level> levels(shell->mass.size(), 0);
                levels[3] = 2;
                levels[7] = levels[8] = 1;
                batches.set_levels(levels);
                Positions x = test::shaken(*shell, 0.02, 5), forces(3, x.cols());
                batches.find(x);
                batches.put_forces(forces);
                for (const Level level : {Level{2}, Level{1}, Level{2}}) {
                    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
                        if (levels[v] >= level) {
                            x.col(v) += 1e-2 * Vector3d(level, 1, -1);
                            batches.move(v, x.col(v));
                        }
                    batches.find_again(level);
                    batches.put_forces_again(level, forces);
                    const Positions expected = test::elastic_gradient(energies, x);
                    EXPECT_LT((forces + expected).norm(), 1e-11 * expected.norm())
                        << "model " << static_cast<int>(options.bending.model) << ", level " << int(level);
                }
            }
}

// Batches that ignored the failure of a hinge would still hold its two faces together.
TEST(ElasticGradient, FollowsAnEdgeThatOpens) {
    for (const ShellEnergyOptions& options : all_models) {
        Shell shell = curved_sheet();
        ShellEnergies energies(shell, options);
        const Threads threads;
        ElasticGradient batches(shell, energies, options, threads);
        const Positions x = test::shaken(shell, 0.02, 5), before = batches.at(x);
        ShellChange change;
        change.removed_hinges = {remove_hinge_of(shell, shell.hinge_edge[20])};
        for (Energy* energy : energies.elastic()) energy->topology_changed(change, {});
        batches.shell_changed();
        const Positions expected = test::elastic_gradient(energies, x);
        EXPECT_GT((before - expected).norm(), 1e-6 * expected.norm());
        EXPECT_LT((batches.at(x) - expected).norm(), 1e-12 * expected.norm());
    }
}

// If the elastic energy did not tell its parts of the failure, steps would continue with the forces of a
// hinge that has been removed.
TEST(ElasticEnergy, FollowsItsPartsWhenAnEdgeOpens) {
    for (const ShellEnergyOptions& options : all_models) {
        Shell shell = curved_sheet();
        ShellEnergies energies(shell, options);
        ElasticEnergy whole(shell, energies, options, Threads());
        const Positions x = test::shaken(shell, 0.02, 5);
        const auto gradient = [&] {
            Positions sum = Positions::Zero(3, x.cols());
            whole.add_gradient(x, sum);
            return sum;
        };
        const Positions before = gradient();
        ShellChange change;
        change.removed_hinges = {remove_hinge_of(shell, shell.hinge_edge[20])};
        whole.topology_changed(change, {});
        const Positions expected = test::elastic_gradient(energies, x);
        EXPECT_GT((before - expected).norm(), 1e-6 * expected.norm());
        EXPECT_LT((gradient() - expected).norm(), 1e-12 * expected.norm());
        double value = 0;
        for (const Energy* part : energies.elastic()) value += part->value(x);
        EXPECT_DOUBLE_EQ(whole.value(x), value);
    }
}

// If the forces depended on the number of threads, a run would depend on the number of the machine's cores.
TEST(ElasticGradient, HasTheSameBitsWithAnyNumberOfThreads) {
    const Shell shell = test::stacked_plates(2, 40, 0.1, test::glass);
    for (const ShellEnergyOptions& options : {all_models[0], all_models[1]}) {
        ShellEnergies energies(shell, options);
        const Positions x = test::shaken(shell, 1e-4, 5);
        const Threads one, two(2), three(3);
        const Positions alone = ElasticGradient(shell, energies, options, one).at(x);
        EXPECT_EQ(ElasticGradient(shell, energies, options, two).at(x), alone);
        EXPECT_EQ(ElasticGradient(shell, energies, options, three).at(x), alone);
    }
}

}  // namespace
}  // namespace sherd
