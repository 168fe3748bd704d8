// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that run scenes depend on observers: a step, a frame or an end that is reported late, twice or not
// at all leaves a recording with gaps.
#include "app/run/runner.h"

#include <gtest/gtest.h>

#include "app/run/recording_header.h"
#include "app/run/run_totals.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"

namespace sherd::test {
namespace {

/// Scene of a disc that falls for ten steps, with a frame every four steps.
const std::string falling = R"(duration = 0.01
[sheet.disc]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.05 }
spin = [30, 20, 0]
material = { preset = "stoneware" }
[solver]
step = 1e-3
[output]
every = 4e-3
)";

Runner runner_of(const std::string& text) {
    const Scene scene = parse_scene(text, "scene.toml");
    std::vector<std::string> warnings;
    return {scene, build_scene(scene, warnings)};
}

/// Notes in `told` how it is called: steps as numbers, frames and the end as words.
struct CallNotes : RunObserver {
    std::string told;
    std::int64_t last_step = 1000;   ///< step after which it requests an end
    std::int64_t worst_step = 1000;  ///< step in which it throws

    void stepped(const StepReport& report, const CrackEvents&) override {
        told += " " + std::to_string(report.step);
        steps = report.step;
        if (steps == worst_step) throw Error("enough", Fault::run);
    }
    void frame_due(const Simulation&) override { told += " frame"; }
    bool should_end() const override { return steps >= last_step; }
    void ended(const RunEnd& end) override { told += " " + end.how; }

  private:
    std::int64_t steps = 0;
};

TEST(Runner, TellsEveryStepAndTheFramesOfTheScene) {
    Runner runner = runner_of(falling);
    CallNotes witness;
    RunTotals totals;
    runner.add(witness);
    runner.add(totals);
    const RunEnd end = runner.run();
    EXPECT_TRUE(end.is_complete());
    EXPECT_GT(end.wall_seconds, 0);
    EXPECT_EQ(witness.told, " frame 1 2 3 4 frame 5 6 7 8 frame 9 10 frame complete");
    EXPECT_EQ(totals.last.step, 10);
    EXPECT_GE(totals.newton_iterations, 10);
}

// Programs that make single steps record them through observers.
TEST(Runner, TellsFramesOfSingleSteps) {
    Runner runner = runner_of(falling);
    CallNotes witness;
    runner.add(witness);
    while (!runner.has_ended()) runner.advance();
    EXPECT_TRUE(runner.is_complete());
    EXPECT_EQ(witness.told, " 1 2 3 4 frame 5 6 7 8 frame 9 10 frame");
}

TEST(Runner, EndsWithAFrameWhereAnObserverWantsIt) {
    Runner runner = runner_of(falling);
    CallNotes witness;
    witness.last_step = 3;
    runner.add(witness);
    EXPECT_EQ(runner.run().how, "interrupted");
    EXPECT_EQ(witness.told, " frame 1 2 3 frame interrupted");
}

TEST(Runner, TellsAllObserversThatItHasFailed) {
    Runner runner = runner_of(falling);
    CallNotes failing, other;
    failing.worst_step = 2;
    runner.add(other);
    runner.add(failing);
    EXPECT_THROW(runner.run(), Error);
    EXPECT_EQ(other.told, " frame 1 2 failed: enough");
    EXPECT_EQ(failing.told, " frame 1 2 failed: enough");
}

TEST(Runner, GoesOnFromWhereSingleStepsHaveLed) {
    Runner whole = runner_of(falling), stepped = runner_of(falling);
    whole.run();
    CallNotes witness;
    stepped.add(witness);
    for (int i = 0; i < 5; ++i) EXPECT_EQ(stepped.step().step, i + 1);
    EXPECT_TRUE(stepped.run().is_complete());
    EXPECT_EQ(witness.told, " 1 2 3 4 5 frame 6 7 8 frame 9 10 frame complete");
    const Snapshot one = whole.simulation().snapshot(), other = stepped.simulation().snapshot();
    EXPECT_TRUE(one.position == other.position);
    EXPECT_TRUE(one.velocity == other.velocity);
}

// If the recorded axis were wrong, cracks along the grain would seem to cross it.
TEST(RecordingHeader, HasTheAxesOfAMaterialThatHasDirections) {
    const auto header_of = [](const std::string& text) {
        const Scene scene = parse_scene(text, "scene.toml");
        std::vector<std::string> warnings;
        return recording_header(scene, Runner(scene, build_scene(scene, warnings)).simulation());
    };
    EXPECT_TRUE(header_of(falling).rest_axis.empty());
    std::string wooden = falling;
    const std::string preset = "{ preset = \"stoneware\" }";
    wooden.replace(wooden.find(preset), preset.size(),
                   "{ preset = \"stoneware\", young = [1e10, 1e9], poisson = 0.3, axis = { degrees = 60 } }");
    const RecordingHeader header = header_of(wooden);
    ASSERT_EQ(header.rest_axis.size(), header.rest_faces.size());
    for (const Vector3d& axis : header.rest_axis)
        EXPECT_LT((axis - Vector3d(0.5, std::sqrt(0.75), 0)).norm(), 1e-12);
}

}  // namespace
}  // namespace sherd::test
