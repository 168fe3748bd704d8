// SPDX-License-Identifier: GPL-3.0-or-later
// All appended frames must be in the file, whatever ends the program or the machine while a recording is
// written.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "app/recording/recording.h"
#include "meshops/error.h"
#include "tests/support/program/simulated_disk.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/same_snapshot.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// A recording to which frames are appended: the folder before, and the system calls of the appends.
struct Appends {
    Appends() : run(synthetic_run()) {
        RecordingWriter writer(folder.path / "run.h5", run.header, false);
        before = folder.contents();
        SystemCalls calls(folder.path);
        for (std::size_t k = 0; k < run.frames.size(); ++k) {
            writer.append(run.frames[k], run.steps[k], run.events[k]);
            done.push_back(calls.made.size());
        }
        made = std::move(calls.made);
    }

    TemporaryDirectory folder;
    SyntheticRun run;
    std::map<std::string, std::string> before;
    std::vector<SystemCall> made;
    std::vector<std::size_t> done;  ///< number of calls until the end of each append
};

/// Expects a recording of the first frames of a run, to the last bit.
void expect_begins(const Recording& recording, const SyntheticRun& run, std::size_t frames) {
    ASSERT_EQ(recording.frame_count(), frames);
    std::size_t steps = 0;
    for (std::size_t k = 0; k < frames; ++k) {
        expect_same(recording.frame(k), run.frames[k]);
        steps += run.steps[k].size();
    }
    EXPECT_EQ(recording.steps().size(), steps);
    recording.events();
}

/// Expects that all appended frames are in the file, if the program ended before the system call of this
/// number.
void expect_survived(const Appends& appends, std::size_t call, const fs::path& file) {
    const auto appended = static_cast<std::size_t>(
        std::ranges::count_if(appends.done, [&](std::size_t i) { return i <= call; }));
    const Recording recording(file);
    const std::size_t frames = recording.frame_count();
    ASSERT_TRUE(frames == appended || (frames == appended + 1 && appended < 3))
        << frames << " frames of " << appended << " at call " << call << " of " << appends.made.size();
    expect_begins(recording, appends.run, frames);
    EXPECT_FALSE(has_journal(file));
}

TEST(RecordingSurvival, EveryFrameIsThereAfterAnyEnd) {
    const Appends appends;
    std::mt19937 random(1);
    const TemporaryDirectory after;
    SimulatedDisk disk(appends.before);
    for (std::size_t call = 0; call <= appends.made.size(); ++call) {
        for (int draw = 0; draw < 4; ++draw) {
            disk.show(after.path, draw == 0, random);
            expect_survived(appends, call, after.path / "run.h5");
            if (HasFatalFailure()) return;
        }
        if (call < appends.made.size()) disk.make(appends.made[call]);
    }
}

// On a read-only medium, or in another user's folder, the journal cannot be applied to the file and remains.
TEST(RecordingSurvival, IsReadByItsJournalWhereItCannotBeMended) {
    const Appends appends;
    std::mt19937 random(1);
    const TemporaryDirectory after;
    const fs::path file = after.path / "run.h5";
    SimulatedDisk disk(appends.before);
    for (std::size_t call = 0; call < appends.made.size(); ++call) {
        disk.make(appends.made[call]);
        disk.show(after.path, true, random);
        const OutputLock lock(file);  // lock of a writer
        const auto left = after.contents();
        const Recording recording(file);
        EXPECT_EQ(recording.recovery(), "");
        expect_begins(recording, appends.run, recording.frame_count());
        for (const auto& [name, bytes] : left) EXPECT_TRUE(after.contents().at(name) == bytes) << name;
    }
}

TEST(RecordingSurvival, SaysWhatHasBeenMended) {
    const Appends appends;
    std::mt19937 random(1);
    const TemporaryDirectory after;
    std::set<std::string> words;
    SimulatedDisk disk(appends.before);
    for (const SystemCall& call : appends.made) {
        disk.make(call);
        disk.show(after.path, true, random);
        const std::string said = Recording(after.path / "run.h5").recovery();
        words.insert(said.substr(0, said.find_last_of(' ')));
        EXPECT_EQ(Recording(after.path / "run.h5").recovery(), "") << "it is mended once";
    }
    EXPECT_GE(words.size(), 3u) << "complete, cut off, or whole";
}

// A complete run is never resumed, so that its index, if it could not be written, would remain missing.
TEST(RecordingSurvival, IsCompleteOnlyWithItsIndex) {
    const SyntheticRun run = synthetic_run();
    const TemporaryDirectory folder;
    RecordingWriter writer(folder.path / "run.h5", run.header, false);
    writer.append(run.frames[0], run.steps[0], run.events[0]);
    fs::remove(folder.path / "run.xdmf");
    fs::create_directory(folder.path / "run.xdmf");
    EXPECT_THROW(writer.finish(1, "complete"), Error);
    EXPECT_EQ(Recording(folder.path / "run.h5").end(), "running");
    fs::remove(folder.path / "run.xdmf");
    writer.finish(1, "complete");
    EXPECT_EQ(Recording(folder.path / "run.h5").end(), "complete");
}

}  // namespace
}  // namespace sherd::test
