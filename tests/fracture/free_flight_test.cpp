// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstdio>

#include "fracture/simulation.h"
#include "meshops/generate.h"

namespace sherd {
namespace {

/// A coarse bowl that spins, flies and vibrates.
SheetInput spinning_bowl() {
    SheetInput shell;
    const std::vector<Vector2d> profile{{0, 0}, {0.05, 0.01}, {0.08, 0.05}};
    shell.mesh = generate_revolution(profile, {0.03, Layout::delaunay, 1});
    shell.material = {2400, 0.002, 1e8, 0.2};
    shell.velocity = Vector3d(1, 2, 3);
    shell.spin = Vector3d(20, -30, 50);
    return shell;
}

SimulationOptions weightless(double step) {
    SimulationOptions options;
    options.step = step;
    options.gravity.setZero();
    options.tolerance = 1e-8;
    return options;
}

// Small errors of one sign would add up over a long run.
TEST(FreeFlight, TenThousandStepsKeepLinearMomentum) {
    Simulation simulation({spinning_bowl()}, weightless(1e-4));
    const Vector3d start = linear_momentum(simulation.sheet().mechanics());
    double drift = 0;
    for (int i = 0; i < 10000; ++i)
        drift = std::max(drift, (simulation.step().linear_momentum - start).norm() / start.norm());
    std::printf("linear momentum after 10000 steps: drift %.2g\n", drift);
    EXPECT_LT(drift, 1e-9);
}

// What implicit Euler takes, and no more: half the step must halve the loss.
TEST(FreeFlight, LossOfAngularMomentumAndEnergyIsOfFirstOrderInTheStep) {
    std::vector<double> angular, energy;
    for (const double step : {4e-5, 2e-5, 1e-5}) {
        Simulation simulation({spinning_bowl()}, weightless(step));
        const Sheet& sheet = simulation.sheet().mechanics();
        // About the centre of mass, which flies with the momentum over the mass.
        const auto spin = [&] {
            const Vector3d centre = sheet.position * sheet.mass / sheet.mass.sum();
            return Vector3d(angular_momentum(sheet) - centre.cross(linear_momentum(sheet)));
        };
        const Vector3d start = spin();
        const double kinetic = kinetic_energy(sheet);
        StepReport report;
        for (int i = 0; i < static_cast<int>(0.02 / step + 0.5); ++i) report = simulation.step();
        angular.push_back(1 - spin().dot(start) / start.squaredNorm());
        energy.push_back(1 - (report.kinetic + report.bending + report.membrane) / kinetic);
        std::printf("step %.0e s, 0.02 s: angular momentum -%.3g %%, energy -%.3g %%\n", step,
                    100 * angular.back(), 100 * energy.back());
    }
    for (const std::vector<double>& loss : {angular, energy}) {
        EXPECT_GT(loss[2], 0);
        for (int i = 0; i < 2; ++i) {
            EXPECT_GT(loss[i] / loss[i + 1], 1.6);
            EXPECT_LT(loss[i] / loss[i + 1], 2.4);
        }
    }
}

}  // namespace
}  // namespace sherd
