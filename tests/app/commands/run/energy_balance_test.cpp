// SPDX-License-Identifier: GPL-3.0-or-later
// Energy balance of whole runs with features that no shipped scene has: every load, moving clamps, wind,
// damping, bodies, statics. If the balance lacked the work of a force, a residual would remain.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/recording/recording.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd {
namespace {

const std::filesystem::path frozen = std::filesystem::path(SHERD_SCENES) / ".." / "tests" / "frozen";

/// Largest of the energies, and largest energy residual of all steps, J.
struct Extremes {
    double energy = 0, unexplained = 0;
};

Extremes extremes(const std::vector<StepReport>& steps) {
    Extremes found;
    for (const StepReport& step : steps) {
        found.energy = std::max({found.energy, step.kinetic, step.bending, step.membrane, step.contact});
        found.unexplained = std::max(found.unexplained, std::abs(step.unexplained));
    }
    return found;
}

/// Runs the scene, expects an energy balance without a residual, and returns the steps.
std::vector<StepReport> balanced_run(const std::filesystem::path& scene, std::vector<std::string> options) {
    const test::TemporaryDirectory directory;
    options.insert(options.begin(), {"run", scene.string(), "-o", "run.h5"});
    const auto result = test::run_sherd(options, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::vector<StepReport> steps = Recording(directory.path / "run.h5").steps();
    const Extremes found = extremes(steps);
    EXPECT_LT(found.unexplained, 1e-6 * found.energy);
    return steps;
}

TEST(EnergyBalance, ClosesWithLoadsWindClampsAndDamping) {
    for (const char* bending : {"nonlinear", "cubic"}) {
        const StepReport last =
            balanced_run(frozen / "supports_and_loads.toml", {"--variant", bending, "--set", "duration=0.02"})
                .back();
        for (const auto part : {&EnergyBalance::work_of_loads, &EnergyBalance::work_of_wind,
                                &EnergyBalance::work_of_supports, &EnergyBalance::lost_to_damping})
            EXPECT_NE(last.*part, 0);
    }
}

TEST(EnergyBalance, ClosesWithBodiesAndAnObstacleThatMoves) {
    const StepReport last = balanced_run(frozen / "bodies.toml", {"--set", "duration=0.02"}).back();
    EXPECT_NE(last.work_of_obstacles, 0);
    EXPECT_GT(last.lost_to_friction, 0);
    EXPECT_GT(last.lost_to_cracks, 0);
}

// In statics the work of loads is stored in the sheet, except for the error of the finite step length.
TEST(EnergyBalance, ClosesInStatics) {
    const test::TemporaryDirectory directory;
    const auto scene = directory.write("bent.toml", R"([sheet.strip]
mesh = { generate = "rectangle", width = 0.3, height = 0.05, edge_length = 0.015 }
material = { preset = "steel", thickness = 1e-3 }
clamp = { box = [[-1, -1, -1], [0.001, 1, 1]] }
[[force.load]]
line = [0, 0, -20]
box = [[0.299, -1, -1], [1, 1, 1]]
[solver]
scheme = "static"
step = 0.05
)");
    const StepReport last = balanced_run(scene, {}).back();
    const double stored = last.bending + last.membrane;
    EXPECT_NEAR(last.work_of_loads, stored, 0.1 * stored);
    EXPECT_NEAR(last.work_of_loads - last.lost_to_scheme, stored, 1e-6 * stored);
}

}  // namespace
}  // namespace sherd
