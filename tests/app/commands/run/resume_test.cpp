// SPDX-License-Identifier: GPL-3.0-or-later
// Resumed runs, through the real program: --resume may not change bits, repeat finished work, or lose
// existing data. (resume_kills.py resumes runs that were killed.)
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/recording/recording.h"
#include "app/run/checkpoint.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/same_report.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* two_triangles = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n";

/// Sheet of two triangles that falls into a gusty wind.
struct Falling {
    Falling() {
        write("square.obj", two_triangles);
        write("fall.toml", R"(duration = 0.01
[sheet.square]
mesh = "square.obj"
material = { preset = "paper" }
[force.wind]
velocity = [2, 0, 0]
gust = { amplitude = 1, time = 0.01, length = 0.1 }
[solver]
step = 1e-3
[output]
every = 3e-3
)");
    }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(directory.path / name) << text;
    }
    ProgramResult run(std::vector<std::string> more) const {
        more.insert(more.begin(), {"run", "fall.toml"});
        return run_sherd(more, directory.path);
    }
    fs::path file(const std::string& name) const { return directory.path / name; }

    TemporaryDirectory directory;
};

void expect_same_recording(const fs::path& one, const fs::path& other) {
    const Recording a(one), b(other);
    const std::vector<StepReport> steps = a.steps(), others = b.steps();
    ASSERT_EQ(steps.size(), others.size());
    for (std::size_t i = 0; i < steps.size(); ++i) expect_same(steps[i], others[i]);
    ASSERT_EQ(a.frame_count(), b.frame_count());
    for (std::size_t i = 0; i < a.frame_count(); ++i) {
        EXPECT_EQ(a.frame(i).step, b.frame(i).step);
        EXPECT_TRUE(same(a.frame(i).position, b.frame(i).position)) << i;
        EXPECT_TRUE(same(a.frame(i).velocity, b.frame(i).velocity)) << i;
    }
    EXPECT_EQ(a.end(), b.end());
    EXPECT_EQ(a.header().scene_text, b.header().scene_text);
}

TEST(Resume, GoesOnFromWhereARunWasEnded) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "whole.h5"}).exit_code, 0);
    const ProgramResult half = scene.run({"-o", "half.h5", "--until", "0.0045"});
    EXPECT_EQ(half.exit_code, 0) << half.err;
    EXPECT_EQ(Recording(scene.file("half.h5")).steps().size(), 5u);
    EXPECT_EQ(Recording(scene.file("half.h5")).end(), "interrupted");
    const ProgramResult rest = scene.run({"-o", "half.h5", "--resume", "--threads", "3"});
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_NE(rest.err.find("is resumed at 0.005 s"), std::string::npos) << rest.err;
    expect_same_recording(scene.file("whole.h5"), scene.file("half.h5"));
}

TEST(Resume, MakesAFinishedRunLonger) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "whole.h5", "--set", "duration=0.016"}).exit_code, 0);
    ASSERT_EQ(scene.run({"-o", "short.h5", "--set", "output.checkpoint=1e-9"}).exit_code, 0);
    const auto checkpoints = checkpoint_files(scene.file("short.h5"));
    EXPECT_NE(fs::exists(checkpoints[0]), fs::exists(checkpoints[1])) << "one is of use";
    const ProgramResult longer = scene.run({"-o", "short.h5", "--resume", "--set", "duration=0.016"});
    EXPECT_EQ(longer.exit_code, 0) << longer.err;
    expect_same_recording(scene.file("whole.h5"), scene.file("short.h5"));
    const ProgramResult shorter = scene.run({"-o", "short.h5", "--resume"});
    EXPECT_EQ(shorter.exit_code, 2);
    EXPECT_NE(shorter.err.find("checkpoint of the run is at 0.016 s, past duration = 0.01"),
              std::string::npos)
        << shorter.err;
}

TEST(Resume, LeavesAFinishedRunAlone) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "run.h5"}).exit_code, 0);
    const auto before = fs::last_write_time(scene.file("run.h5"));
    const ProgramResult again = scene.run({"-o", "run.h5", "--resume"});
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_NE(again.err.find("nothing is left to do"), std::string::npos) << again.err;
    EXPECT_EQ(fs::last_write_time(scene.file("run.h5")), before);
}

// A complete run keeps no checkpoints, which were once larger than its recording. A user who wants to make
// the run longer must be told how, and a changed scene must not count as complete.
TEST(Resume, KeepsNoCheckpointOfACompleteRun) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "run.h5"}).exit_code, 0);
    for (const fs::path& file : checkpoint_files(scene.file("run.h5")))
        EXPECT_FALSE(fs::exists(file)) << file;
    const ProgramResult longer = scene.run({"-o", "run.h5", "--resume", "--set", "duration=0.016"});
    EXPECT_EQ(longer.exit_code, 2);
    EXPECT_NE(longer.err.find("--force instead of --resume"), std::string::npos) << longer.err;
    const ProgramResult damped = scene.run({"-o", "run.h5", "--resume", "--set", "solver.damping.mass=1"});
    EXPECT_EQ(damped.exit_code, 2);
    EXPECT_NE(damped.err.find("its scene had another text"), std::string::npos) << damped.err;
}

// A run that is killed may have recorded frames after its last checkpoint. If a message named the time of the
// checkpoint only, it would contradict `sherd info`. The killed run is made of a longer recording and the
// checkpoint of a shorter one.
TEST(Resume, TellsOfFramesBeyondTheLastCheckpoint) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "whole.h5"}).exit_code, 0);
    ASSERT_EQ(scene.run({"-o", "run.h5", "--until", "0.004"}).exit_code, 0);
    fs::copy_file(scene.file("whole.h5"), scene.file("run.h5"), fs::copy_options::overwrite_existing);
    const ProgramResult none = scene.run({"-o", "run.h5", "--resume", "--until", "0.003"});
    EXPECT_EQ(none.exit_code, 0) << none.err;
    EXPECT_NE(
        none.err.find("the last checkpoint of 'run.h5' is at 0.004 s, not before --until: nothing "
                      "is left to do; frames beyond it, up to 0.01 s, will be made again when the run is "
                      "resumed"),
        std::string::npos)
        << none.err;
    expect_same_recording(scene.file("whole.h5"), scene.file("run.h5"));
    const ProgramResult rest = scene.run({"-o", "run.h5", "--resume", "--until", "0.006"});
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_NE(
        rest.err.find("'run.h5' is resumed at 0.004 s, its last checkpoint; frames beyond it, up to 0.01 s, "
                      "are made again"),
        std::string::npos)
        << rest.err;
    const Recording cut(scene.file("run.h5"));
    EXPECT_EQ(cut.steps().size(), 6u) << "the frames beyond the checkpoint are gone";
}

// The last step ends after the duration if the duration is no multiple of the step, and by round-off after
// many durations that are: nine steps of 0.001 s exceed 0.009 s. Such a run was once refused as too long.
TEST(Resume, LeavesARunAloneWhoseLastStepEndsAfterItsDuration) {
    const Falling scene;
    for (const double duration : {0.0085, 0.009}) {
        const std::string setting = "duration=" + std::to_string(duration);
        ASSERT_EQ(scene.run({"-o", "run.h5", "--force", "--set", setting}).exit_code, 0);
        ASSERT_GT(Recording(scene.file("run.h5")).steps().back().time, duration);
        const ProgramResult again = scene.run({"-o", "run.h5", "--resume", "--set", setting});
        EXPECT_EQ(again.exit_code, 0) << again.err;
        EXPECT_NE(again.err.find("nothing is left to do"), std::string::npos) << again.err;
    }
}

TEST(Resume, NamesWhatHasChanged) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "run.h5", "--until", "0.004"}).exit_code, 0);
    const ProgramResult stepped = scene.run({"-o", "run.h5", "--resume", "--set", "solver.step=2e-3"});
    EXPECT_EQ(stepped.exit_code, 2);
    EXPECT_NE(stepped.err.find("solver.step was 0.001 and is 0.002"), std::string::npos) << stepped.err;
    // Settings hold this number as 2.0000000000000002e-05, and a user would look for a difference that is
    // none.
    const ProgramResult finer = scene.run({"-o", "run.h5", "--resume", "--set", "solver.step=2e-5"});
    EXPECT_NE(finer.err.find("solver.step was 0.001 and is 2e-05\n"), std::string::npos) << finer.err;
    EXPECT_NE(finer.err.find("only duration and output.checkpoint may differ"), std::string::npos)
        << finer.err;
    const ProgramResult damped = scene.run({"-o", "run.h5", "--resume", "--set", "solver.damping.mass=1"});
    EXPECT_EQ(damped.exit_code, 2);
    EXPECT_NE(damped.err.find("solver.damping.mass = 1 has been added"), std::string::npos) << damped.err;
    scene.write("square.obj", std::string(two_triangles) + "# another one\n");
    const ProgramResult meshed = scene.run({"-o", "run.h5", "--resume"});
    EXPECT_EQ(meshed.exit_code, 2);
    EXPECT_NE(meshed.err.find("the mesh 'square.obj' has changed"), std::string::npos) << meshed.err;
    EXPECT_EQ(Recording(scene.file("run.h5")).steps().size(), 4u);
}

TEST(Resume, TakesTheOlderCheckpointWhenTheNewerIsTorn) {
    const Falling scene;
    ASSERT_EQ(scene.run({"-o", "whole.h5"}).exit_code, 0);
    ASSERT_EQ(scene.run({"-o", "run.h5", "--until", "0.004"}).exit_code, 0);
    const auto files = checkpoint_files(scene.file("run.h5"));
    fs::resize_file(files[0], fs::file_size(files[0]) - 1);  // has checkpoint number 2; files[1] has number 1
    const ProgramResult rest = scene.run({"-o", "run.h5", "--resume"});
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_NE(rest.err.find("run.h5.checkpoint-1' is damaged or cut off"), std::string::npos) << rest.err;
    EXPECT_NE(rest.err.find("is resumed at 0 s"), std::string::npos) << rest.err;
    expect_same_recording(scene.file("whole.h5"), scene.file("run.h5"));
}

TEST(Resume, BeginsWhereNothingIsAndRefusesWhatItCannotGoOnWith) {
    const Falling scene;
    const ProgramResult first = scene.run({"-o", "run.h5", "--resume", "--until", "0.004"});
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_NE(first.err.find("has not been started"), std::string::npos) << first.err;
    for (const fs::path& file : checkpoint_files(scene.file("run.h5"))) fs::remove(file);
    const ProgramResult lost = scene.run({"-o", "run.h5", "--resume"});
    EXPECT_EQ(lost.exit_code, 2);
    EXPECT_NE(lost.err.find("has no checkpoint to resume from"), std::string::npos) << lost.err;
    EXPECT_EQ(scene.run({"-o", "run.h5", "--resume", "--force", "--until", "0.004"}).exit_code, 0);
    fs::remove(scene.file("run.h5"));
    const ProgramResult gone = scene.run({"-o", "run.h5", "--resume"});
    EXPECT_EQ(gone.exit_code, 2);
    EXPECT_NE(gone.err.find("but not the recording itself"), std::string::npos) << gone.err;
}

TEST(Resume, DoesWhatIsLeftOfEachVariant) {
    const Falling scene;
    scene.write("fall.toml", R"(duration = 0.004
[sheet.square]
mesh = "square.obj"
material = { preset = "paper" }
[solver]
step = 1e-3
[[variant]]
name = "done"
[[variant]]
name = "half"
force.gravity = [0, 0, -1]
[[variant]]
name = "none"
force.gravity = [0, 0, -2]
)");
    ASSERT_EQ(scene.run({"-o", "whole"}).exit_code, 0);
    fs::create_directory(scene.file("runs"));
    ASSERT_EQ(scene.run({"--variant", "done", "-o", "runs/fall-done.h5"}).exit_code, 0);
    ASSERT_EQ(scene.run({"--variant", "half", "-o", "runs/fall-half.h5", "--until", "0.002"}).exit_code, 0);
    const auto before = fs::last_write_time(scene.file("runs/fall-done.h5"));
    const ProgramResult all = scene.run({"-o", "runs", "--resume"});
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(fs::last_write_time(scene.file("runs/fall-done.h5")), before);
    for (const char* name : {"fall-done.h5", "fall-half.h5", "fall-none.h5"})
        expect_same_recording(scene.file("whole") / name, scene.file("runs") / name);
}

}  // namespace
}  // namespace sherd::test
