// SPDX-License-Identifier: GPL-3.0-or-later
// Local time steps. A wrong list of the elements that depend on a vertex would leave old forces in place;
// without symmetry or stability the energy of a sheet would grow.
#include "core/time/local_steps.h"

#include <gtest/gtest.h>

#include "core/time/frequency_bounds.h"
#include "core/time/substep_levels.h"
#include "tests/support/shell/eigenpairs.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

/// A plate of 11 x 11 vertices whose vertex in the middle has been moved next to another one, so that the
/// faces between them are narrow.
Shell plate_with_narrow_faces(double ratio, double thickness = test::glass.thickness) {
    Material material = test::glass;
    material.thickness = thickness;
    Shell shell = test::stacked_plates(1, 10, 0, material);
    Positions rest = shell.rest;
    rest.col(60) = rest.col(61) + (rest.col(60) - rest.col(61)) / ratio;
    std::vector<std::array<Index, 3>> triangles;
    for (const TriangleStencil& triangle : shell.triangles) triangles.push_back(triangle.vertices);
    return test::small_sheet(rest, triangles, material);
}

struct Sheet {
    explicit Sheet(Shell made, BendingModel model = BendingModel::coupled)
        : shell(std::move(made)), options{.bending = {model}} {}

    Shell shell;
    ShellEnergyOptions options;
    ShellEnergies energies{shell, options};
    ElasticGradient gradient{shell, energies, options, Threads()};
    LocalSteps steps{shell, gradient};
    Positions none = Positions::Zero(3, shell.position.cols());

    Positions forces(const Positions& x, double length) {
        Positions elastic;
        steps.find(x, length, none, elastic);
        return elastic;
    }
};

/// The recursion of LocalSteps with the gradient of all elements.
Positions expected_forces(Sheet& sheet, ElasticGradient& all, const std::vector<Level>& levels,
                          const Positions& x, double length, int level) {
    if (level == *std::ranges::max_element(levels)) return -all.at(x);
    const Positions one = expected_forces(sheet, all, levels, x, length, level + 1);
    const double finer = length / (2 << level);
    Positions moved = x;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        if (levels[v] > level)
            moved.col(v) +=
                0.5 * (1 + LocalSteps::stabilization) * finer * finer / sheet.shell.mass[v] * one.col(v);
    return 0.5 * (one + expected_forces(sheet, all, levels, moved, length, level + 1));
}

std::vector<Level> some_levels(const Shell& shell) {
    std::vector<Level> levels(shell.mass.size(), 0);
    for (const auto& [vertex, level] :
         {std::pair{60, 3}, {61, 3}, {72, 2}, {30, 1}, {31, 1}, {100, 1}, {5, 2}})
        levels[vertex] = static_cast<Level>(level);
    return levels;
}

TEST(LocalSteps, AreTheMeansOfForcesAlongTheEvenMotion) {
    for (const BendingModel model : {BendingModel::coupled, BendingModel::cubic}) {
        Sheet sheet(plate_with_narrow_faces(3), model);
        Sheet other(sheet.shell, model);
        const std::vector<Level> levels = some_levels(sheet.shell);
        sheet.steps.set_levels(levels);
        const Positions x = test::shaken(sheet.shell, 1e-4, 5);
        const double length = 1e-6;
        const Positions expected = expected_forces(other, other.gradient, levels, x, length, 0);
        const Positions found = sheet.forces(x, length), plain = -other.gradient.at(x);
        ASSERT_GT((plain - expected).norm(), 1e-3 * expected.norm());
        // The correction of torques is small.
        EXPECT_LT((found - expected).norm(), 1e-3 * (plain - expected).norm());
    }
}

// A sheet in flight must neither accelerate nor begin to turn by itself.
TEST(LocalSteps, ExertNoNetForceAndNoTorque) {
    Sheet sheet(plate_with_narrow_faces(3));
    sheet.steps.set_levels(some_levels(sheet.shell));
    const Positions x = test::shaken(sheet.shell, 1e-3, 5), forces = sheet.forces(x, 1e-6);
    const double size = forces.colwise().norm().sum();
    EXPECT_LT(forces.rowwise().sum().norm(), 1e-13 * size);
    Vector3d torque = Vector3d::Zero();
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        torque += Vector3d(x.col(v)).cross(Vector3d(forces.col(v)));
    EXPECT_LT(torque.norm(), 1e-13 * size * x.colwise().norm().maxCoeff());
}

/// The matrix of the forces by local steps on small displacements from rest, times length^2, with
/// displacements and forces scaled by the root of the mass.
Eigen::MatrixXd scaled_matrix(Sheet& sheet, double length) {
    const double trial = 1e-9;
    const VectorXd root = sheet.shell.mass.cwiseSqrt().replicate(1, 3).transpose().reshaped();
    Eigen::MatrixXd matrix(root.size(), root.size());
    for (Index i = 0; i < static_cast<Index>(root.size()); ++i) {
        Positions ahead = sheet.shell.rest, behind = sheet.shell.rest;
        ahead.reshaped()[i] += trial;
        behind.reshaped()[i] -= trial;
        const Positions slope = (sheet.forces(behind, length) - sheet.forces(ahead, length)) / (2 * trial);
        matrix.col(i) = length * length / root[i] * slope.reshaped().cwiseQuotient(root);
    }
    return matrix;
}

// Leapfrog with a force matrix A and a substep h is stable, and keeps an energy, if A is symmetric with
// eigenvalues from 0 to 4 / h^2. Between levels, a vibration that is too fast for its neighbours could break
// this, at particular lengths of the substep.
TEST(LocalSteps, AreSymmetricAndStableAtSubstepsOfAllLengths) {
    for (const auto& [thickness, ratio] :
         {std::pair{0.001, 12.0}, {0.01, 12.0}, {0.03, 12.0}, {0.01, 30.0}}) {
        Sheet sheet(plate_with_narrow_faces(ratio, thickness));
        FrequencyBounds bounds;
        bounds.find(sheet.energies.elastic(), sheet.shell, sheet.shell.rest);
        const VectorXd stable = 1.8 / bounds.squares().array().sqrt();
        std::vector<double> sorted(stable.begin(), stable.end());
        std::ranges::sort(sorted);
        const double longest = sorted[sorted.size() / 8];
        Level highest = 0;
        for (int i = 0; i < 10; ++i) {
            const double length = longest * (1 - 0.045 * i);
            const std::vector<Level> levels =
                levels_in(sheet.shell, stable, length, LocalSteps::share_of_stable);
            highest = std::max(highest, *std::ranges::max_element(levels));
            sheet.steps.set_levels(levels);
            const Eigen::MatrixXd matrix = scaled_matrix(sheet, length);
            EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-7 * matrix.norm());
            const VectorXd values = test::eigenvalues(0.5 * (matrix + matrix.transpose()));
            EXPECT_GT(values.minCoeff(), -1e-9);
            EXPECT_LT(values.maxCoeff(), 4 / (1 + LocalSteps::stabilization) * (1 + 1e-6));
        }
        EXPECT_GE(highest, 2);
    }
}

// A plate that rings by itself must keep its energy: substeps of different lengths at different vertices must
// not excite each other. Where all vibrations of a mesh have the same energy at the start, the energy of
// those faster than the substep is not kept, but it must not grow.
TEST(LocalSteps, KeepTheEnergyOfARingingPlate) {
    Sheet sheet(plate_with_narrow_faces(20, 0.01));
    Shell& shell = sheet.shell;
    FrequencyBounds bounds;
    bounds.find(sheet.energies.elastic(), shell, shell.rest);
    const VectorXd stable = 1.8 / bounds.squares().array().sqrt();
    std::vector<double> sorted(stable.begin(), stable.end());
    std::ranges::sort(sorted);
    Positions wave = Positions::Zero(3, shell.rest.cols());
    for (Index v = 0; v < static_cast<Index>(wave.cols()); ++v)
        wave(2, v) = std::cos(60 * shell.rest(0, v)) * std::cos(30 * shell.rest(1, v));
    const Positions noise = test::shaken(shell, 1, 5) - shell.rest;
    for (const bool is_noise : {false, true})
        for (const double part : {0.99, 0.83}) {
            const double length = part * sorted[sorted.size() / 8];
            sheet.steps.set_levels(levels_in(shell, stable, length, LocalSteps::share_of_stable));
            ASSERT_GE(sheet.steps.highest(), 3);
            Positions x = shell.rest, velocity = 1e-3 * (is_noise ? noise : wave);
            Positions elastic = sheet.forces(x, length);
            const auto kick = [&] {
                velocity += length / 2 * elastic * shell.mass.cwiseInverse().asDiagonal();
            };
            const auto energy = [&] {
                double sum = kinetic_energy(shell.mass, velocity);
                for (const Energy* one : sheet.energies.elastic()) sum += one->value(x);
                return sum;
            };
            double start = energy();
            for (int phase = 0; phase < 4; ++phase) {
                double mean = 0;
                for (int i = 0; i < 1000; ++i) {
                    kick();
                    x += length * velocity;
                    elastic = sheet.forces(x, length);
                    kick();
                    mean += energy() / 1000;
                }
                if (is_noise && phase == 0) start = mean;
                EXPECT_NEAR(mean, start, 0.01 * start) << "phase " << phase << (is_noise ? " of noise" : "");
            }
        }
}

}  // namespace
}  // namespace sherd
