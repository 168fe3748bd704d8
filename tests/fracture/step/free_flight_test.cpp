// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cstdio>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

/// First axis of each face: as near to (2, 1, 0) as its plane allows.
std::vector<Vector3d> level_axes(const Mesh& mesh) {
    std::vector<Vector3d> axes;
    for (const Face face : mesh.faces()) {
        std::vector<Vector3d> corners;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) {
            const Point& p = mesh.point(v);
            corners.emplace_back(p.x(), p.y(), p.z());
        }
        const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        const Vector3d direction(2, 1, 0);
        axes.push_back((direction - normal.dot(direction) * normal).normalized());
    }
    return axes;
}

/// Coarse bowl that spins, flies and vibrates; five times as stiff along its first axis as across.
SheetInput spinning_bowl() {
    SheetInput shell;
    const std::vector<Vector2d> profile{{0, 0}, {0.05, 0.01}, {0.08, 0.05}};
    shell.mesh = generate_revolution(profile, {0.03, Layout::delaunay, 1});
    shell.material = {2400, 0.002, 1e8, 0.2, 2e7, 1.6e7};
    shell.axes = level_axes(shell.mesh);
    shell.velocity = Vector3d(1, 2, 3);
    shell.spin = Vector3d(20, -30, 50);
    return shell;
}

SimulationOptions weightless(double step, BendingModel model) {
    SimulationOptions options;
    options.stepper.step = step;
    options.stepper.shell.bending = {model, exact_jacobian(model)};
    options.stepper.gravity.setZero();
    options.tolerance = 1e-8;
    return options;
}

constexpr std::array models{BendingModel::cubic, BendingModel::cubic_2007, BendingModel::nonlinear};
constexpr std::array names{"cubic", "cubic-2007", "nonlinear"};

/// Largest relative change of the linear momentum over `steps` steps.
double drift(BendingModel model, int steps) {
    Simulation simulation({spinning_bowl()}, weightless(1e-4, model));
    const Vector3d start = linear_momentum(simulation.shell().mechanics());
    double largest = 0;
    for (int i = 0; i < steps; ++i)
        largest = std::max(largest, (simulation.step().linear_momentum - start).norm() / start.norm());
    return largest;
}

// Small errors of one sign would add up over a long run.
TEST(FreeFlight, TenThousandStepsKeepLinearMomentum) {
    const double change = drift(BendingModel::cubic, 10000);
    std::printf("linear momentum after 10000 steps: drift %.2g\n", change);
    EXPECT_LT(change, 1e-9);
}

// A bending model with a net force would push the bowl. Here are a tenth of the steps above, with a tenth of
// the bound.
TEST(FreeFlight, EachBendingModelKeepsLinearMomentum) {
    for (std::size_t m = 0; m < models.size(); ++m) {
        const double change = drift(models[m], 1000);
        std::printf("%-10s linear momentum after 1000 steps: drift %.2g\n", names[m], change);
        EXPECT_LT(change, 1e-10);
    }
}

/// Brings a sheet to equilibrium, which with cubic-2007 is not its rest shape, and restores its velocity:
/// from the rest shape it would vibrate, and the damping of this vibration would count as loss.
void settle_in_motion(Shell& sheet, StepperOptions options) {
    const Positions motion = sheet.velocity;
    sheet.velocity.setZero();
    options.step = 1e-2;
    test::settle(sheet, options, 50);
    sheet.velocity = motion;
}

/// Relative losses of a flight of 0.02 s.
struct Loss {
    double angular_momentum, energy;
};
Loss loss(BendingModel model, double step) {
    BreakableShell bowl({spinning_bowl()});
    Shell& sheet = bowl.mechanics();
    StepperOptions options;
    options.step = step;
    options.gravity.setZero();
    options.shell.bending = {model, exact_jacobian(model)};
    options.tolerance = 1e-8;
    settle_in_motion(sheet, options);
    ImplicitStepper time_step(sheet, options);
    time_step.begin();
    time_step.position = sheet.position;  // the energies below are those at these positions
    const auto energy = [&] {
        const PotentialEnergies potential = time_step.energies();
        return kinetic_energy(sheet) + potential.bending + potential.membrane;
    };
    // angular momentum about the centre of mass, which moves with the momentum over the mass
    const auto spin = [&] {
        const Vector3d centre = sheet.position * sheet.mass / sheet.mass.sum();
        return Vector3d(angular_momentum(sheet) - centre.cross(linear_momentum(sheet)));
    };
    const Vector3d spin_before = spin();
    const double energy_before = energy();
    for (int i = 0; i < static_cast<int>(0.02 / step + 0.5); ++i) {
        time_step.begin();
        EXPECT_TRUE(time_step.solve(50));
        time_step.finish();
    }
    return {1 - spin().dot(spin_before) / spin_before.squaredNorm(), 1 - energy() / energy_before};
}

// The loss must be that of implicit Euler alone: half the step must halve the loss, and no bending model may
// add to it.
TEST(FreeFlight, LossOfAngularMomentumAndEnergyIsOfFirstOrderInTheStepWithEachBendingModel) {
    const std::array<double, 3> steps{4e-5, 2e-5, 1e-5};
    std::array<std::array<Loss, 3>, 3> lost;
    for (std::size_t m = 0; m < models.size(); ++m) {
        for (int i = 0; i < 3; ++i) {
            lost[m][i] = loss(models[m], steps[i]);
            const auto [angular, energy] = lost[m][i];
            std::printf("%-10s step %.0e s, 0.02 s: angular momentum -%.4g %%, energy -%.4g %%\n", names[m],
                        steps[i], 100 * angular, 100 * energy);
            EXPECT_NEAR(angular / lost[0][i].angular_momentum, 1, 0.002);
            EXPECT_NEAR(energy / lost[0][i].energy, 1, 0.005);
        }
        for (const auto part : {&Loss::angular_momentum, &Loss::energy}) {
            EXPECT_GT(lost[m][2].*part, 0);
            for (int i = 0; i < 2; ++i) {
                EXPECT_GT(lost[m][i].*part / (lost[m][i + 1].*part), 1.6);
                EXPECT_LT(lost[m][i].*part / (lost[m][i + 1].*part), 2.4);
            }
        }
    }
}

}  // namespace
}  // namespace sherd
