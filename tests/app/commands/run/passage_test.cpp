// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that strike a sheet within a step or two must not end behind it, nor crash the program.
#include <gtest/gtest.h>

#include "app/recording/recording.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string pane = R"(
[force]
gravity = [0, 0, 0]
[sheet.pane]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.012 }
place = { translate = [-0.05, -0.05, 0] }
)";

struct Blow {
    explicit Blow(const std::string& scene, const std::string& struck = pane) {
        directory.write("scene.toml", scene + struck);
        result = run_sherd({"run", "scene.toml", "-o", "run.h5"}, directory.path);
    }
    std::vector<StepReport> steps() const { return Recording(directory.path / "run.h5").steps(); }
    /// Whether the run ended with an error that an object passes through another, or that a step cannot be
    /// solved.
    bool is_refused() const {
        return result.exit_code == 1 && (result.err.find("passes through") != std::string::npos ||
                                         result.err.find("cannot be solved") != std::string::npos);
    }

    TemporaryDirectory directory;
    ProgramResult result;
};

// In one step the sheet moves five times its distance to the pane. The minimiser once moved it round the
// pane's rim.
TEST(Passage, ASheetDoesNotJumpBehindAnother) {
    const Blow blow(R"(duration = 0.02
[solver]
step = 0.005
[output]
every = 0.005
[sheet.flying]
mesh = { generate = "rectangle", width = 0.04, height = 0.04, edge_length = 0.012 }
place = { translate = [-0.02, -0.02, 0.031] }
velocity = [0, 0, -40]
material = { preset = "glass" }
[sheet.pane.material]
preset = "pmma"
)");
    if (blow.is_refused()) return;
    ASSERT_EQ(blow.result.exit_code, 0) << blow.result.err;
    const std::vector<StepReport> steps = blow.steps();
    EXPECT_LT(steps.back().kinetic, 0.9 * 12.8) << "J: the pane took nothing of the blow";
}

// The pane, which does not fracture, must be in front of the hammer, whose face ends at z = -185 mm.
TEST(Passage, AHammerThatIsToldToGoThroughAPaneTakesItAlong) {
    const Blow blow(R"(duration = 0.003
[output]
every = 1e-3
[obstacle.hammer]
box = { size = [0.03, 0.03, 0.01], centre = [0, 0, 0.02] }
motion = "linear"
keys = [{ time = 0 }, { time = 0.002 }, { time = 0.0021, translate = [0, 0, -0.2] }]
[sheet.pane.pin]
boundary = true
[sheet.pane.material]
preset = "glass"
)");
    if (blow.is_refused()) return;
    ASSERT_EQ(blow.result.exit_code, 0) << blow.result.err;
    const Recording recording(blow.directory.path / "run.h5");
    const Snapshot end = recording.frame(recording.frame_count() - 1);
    EXPECT_LT(end.position.row(2).minCoeff(), -0.185);
}

// The impact is too strong for the contact springs of explicit steps. The program once looked for passages
// only between sheets and obstacles.
TEST(Passage, AFreeBallThatPassesASheetInExplicitStepsEndsTheRun) {
    const Blow blow(R"(duration = 6e-4
[solver]
scheme = "explicit"
[output]
every = 1e-4
[obstacle.ball]
sphere = { radius = 0.004, centre = [0, 0, 0.031] }
density = 7850
velocity = [0, 0, -100]
[sheet.pane.pin]
boundary = true
[sheet.pane.material]
preset = "eggshell"
)");
    EXPECT_EQ(blow.result.exit_code, 1) << blow.result.err;
    EXPECT_NE(blow.result.err.find("a free body through a sheet"), std::string::npos) << blow.result.err;
}

// Crack faces separate during explicit steps, and implicit steps follow: this once ended in a segmentation
// fault.
TEST(BreakingPassage, AutoGoesOnWithAFreeBallAndCracksThatPart) {
    const Blow blow(R"(duration = 1e-3
[force]
gravity = [0, 0, 0]
[solver]
scheme = "auto"
step = 5e-5
[output]
every = 5e-4
[obstacle.ball]
sphere = { radius = 0.006, centre = [0.01, 0.005, 0.008] }
density = 7850
velocity = [0, 0, -60]
[sheet.pane]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.009 }
place = { translate = [-0.05, -0.05, 0] }
material = { preset = "glass", thickness = 0.003 }
fracture = { preset = true }
)",
                    "");
    EXPECT_EQ(blow.result.exit_code, 0) << blow.result.err;
}

}  // namespace
}  // namespace sherd::test
