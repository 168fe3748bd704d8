// SPDX-License-Identifier: GPL-3.0-or-later
// Each output has one writer: two programs at once must not overwrite each other's files.
#include "app/files/disk/output_lock.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>
#include <vector>

#include "app/recording/recording.h"
#include "meshops/error.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/falling_disc.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Message of the error if `output` cannot be locked; "" if it can.
std::string refusal(const fs::path& output) {
    try {
        OutputLock lock(output);
        return "";
    } catch (const Error& error) {
        EXPECT_EQ(error.fault, Fault::input) << error.what();
        return error.what();
    }
}

TEST(OutputLock, IsGivenToOneAtATimeAndSaysToWhom) {
    const TemporaryDirectory directory;
    const fs::path output = directory.path / "run.h5";
    {
        const OutputLock lock(output);
        const std::string text = refusal(output);
        EXPECT_TRUE(text.starts_with("'" + output.string() + "' is being written by '")) << text;
        EXPECT_TRUE(contains(text, program_invocation_short_name)) << text;
        EXPECT_TRUE(contains(text, "(process " + std::to_string(getpid()) + " on ")) << text;
        EXPECT_TRUE(contains(text, ", since 2")) << text;
        EXPECT_TRUE(contains(text, "name another output")) << text;
        EXPECT_EQ(refusal(directory.path / "." / "run.h5").empty(), false) << "the same file by another name";
        EXPECT_EQ(refusal(directory.path / "other.h5"), "");
    }
    EXPECT_TRUE(fs::is_empty(directory.path));
    EXPECT_EQ(refusal(output), "");
}

TEST(OutputLock, IsOnlyOnceInTheWayOfAMovedOne) {
    const TemporaryDirectory directory;
    OutputLock first(directory.path / "run.h5");
    {
        const OutputLock second(std::move(first));
        EXPECT_NE(refusal(directory.path / "run.h5"), "");
    }
    EXPECT_TRUE(fs::is_empty(directory.path));
}

// Lock files that a killed program has left must not block other programs.
TEST(OutputLock, AFileThatNobodyHasLockedBlocksNobody) {
    const TemporaryDirectory directory;
    directory.write("run.h5.lock",
                    "written by 'sherd run' (process 1 on elsewhere, since 2001-01-01 00:00:00)\n");
    directory.write("empty.h5.lock", "");
    for (const std::string name : {"run.h5", "empty.h5"}) {
        const OutputLock lock(directory.path / name);
        const std::string text = refusal(directory.path / name);
        EXPECT_TRUE(contains(text, std::to_string(getpid()))) << text;
        EXPECT_FALSE(contains(text, "elsewhere")) << text;
    }
    EXPECT_TRUE(fs::is_empty(directory.path));
}

TEST(OutputLock, DoesNotTakeSomebodysFileForALock) {
    const TemporaryDirectory directory;
    directory.write("run.h5.lock", "of a cupboard");
    directory.write("target", "somebody's");
    fs::create_symlink(directory.path / "target", directory.path / "linked.h5.lock");
    fs::create_directory(directory.path / "folder.h5.lock");
    const auto before = directory.contents();
    for (const std::string name : {"run.h5", "linked.h5", "folder.h5"}) {
        const std::string text = refusal(directory.path / name);
        EXPECT_TRUE(contains(text, name + ".lock'") && contains(text, "remove it")) << text;
    }
    EXPECT_EQ(directory.contents(), before);
}

// The content of another program's lock file is printed on a terminal: control characters must be removed.
TEST(OutputLock, ShowsNothingThatATerminalWouldObey) {
    const TemporaryDirectory directory;
    const fs::path file = directory.write("run.h5.lock", "written by \x1b[2J\a (process 7)\nmore\n");
    const int descriptor = open(file.c_str(), O_RDONLY);
    ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
    const std::string text = refusal(directory.path / "run.h5");
    EXPECT_TRUE(contains(text, "written by ?[2J? (process 7); ")) << text;
    close(descriptor);
}

// A program must count as the writer also before it has written its name into the lock file.
TEST(OutputLock, OfOneThatDoesNotSayWhoItIsIsALockAllTheSame) {
    const TemporaryDirectory directory;
    const int descriptor = open(directory.write("run.h5.lock", "").c_str(), O_RDONLY);
    ASSERT_EQ(flock(descriptor, LOCK_EX), 0);
    EXPECT_TRUE(contains(refusal(directory.path / "run.h5"), "run.h5' is being written; "))
        << refusal("run.h5");
    close(descriptor);
}

TEST(OutputLock, OfManyAtOnceOneGetsIt) {
    const TemporaryDirectory directory;
    const fs::path output = directory.path / "run.h5";
    std::atomic<int> inside = 0, most = 0, times = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i)
        threads.emplace_back([&] {
            for (int round = 0; round < 5000; ++round) try {
                    const OutputLock lock(output);
                    const int now = ++inside;
                    if (now > most) most = now;
                    std::this_thread::sleep_for(std::chrono::microseconds(20));
                    ++times;
                    --inside;
                } catch (const Error&) {
                }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(most, 1) << "two had the lock at the same time";
    EXPECT_GT(times, 0);
    EXPECT_TRUE(fs::is_empty(directory.path));
}

TEST(OutputLock, IsNotToBeHadWhereNothingCanBeWritten) {
    EXPECT_TRUE(contains(refusal("/proc/run.h5"), "cannot create '/proc/run.h5'"));
    EXPECT_TRUE(contains(refusal("/no such folder/run.h5"), "name a file in a folder that exists"));
}

// Sherd must work on a file system without locks, but not let two programs write one output.
TEST(OutputLock, WithoutLocksOfTheFileSystemTheFileIsTheLock) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    ProgramLimits limits;
    limits.no_locks = true;
    const std::vector<std::string> command{"run", "scene.toml", "--force"};
    const ProgramResult alone = run_sherd(command, directory.path, limits);
    EXPECT_EQ(alone.exit_code, 0) << alone.err;
    EXPECT_FALSE(fs::exists(directory.path / "scene.h5.lock"));
    directory.write("scene.h5.lock",
                    "written by 'sherd run' (process 1 on elsewhere, since 2001-01-01 00:00:00)\n");
    const ProgramResult second = run_sherd(command, directory.path, limits);
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_TRUE(contains(second.err, "process 1 on elsewhere")) << second.err;
    EXPECT_TRUE(contains(second.err, "remove 'scene.h5.lock'")) << second.err;
}

void wait_for(const fs::path& file) {
    for (int i = 0; i < 24'000 && !fs::exists(file); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(OutputLock, ASecondRunIsRefusedAndTheFirstOnesRecordingStays) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    ProgramResult second;
    std::string first;
    const auto meanwhile = [&](pid_t program) {
        wait_for(directory.path / "out.xdmf");
        first = std::to_string(program);
        second = run_sherd({"run", "scene.toml", "-o", "./out.h5", "--force"}, directory.path);
        kill(program, SIGINT);
    };
    const ProgramResult result = run_sherd({"run", "scene.toml", "-o", "out.h5", "--set", "duration=1000"},
                                           directory.path, {}, meanwhile);
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_TRUE(contains(second.err,
                         "sherd: error: './out.h5' is being written by 'sherd run scene.toml -o out.h5 "
                         "--set duration=1000' (process " +
                             first + " on "))
        << second.err;
    EXPECT_EQ(result.exit_code, 130) << result.err;
    const Recording recording(directory.path / "out.h5");
    EXPECT_EQ(recording.end(), "interrupted");
    EXPECT_GE(recording.frame_count(), 1u);
    EXPECT_TRUE(contains(recording.header().scene_text, "duration=1000"));
    EXPECT_FALSE(fs::exists(directory.path / "out.h5.lock") || fs::exists(directory.path / "out.xdmf.lock"));
}

TEST(OutputLock, AKilledRunLeavesNothingThatBlocks) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    const auto kill_it = [&](pid_t program) {
        wait_for(directory.path / "out.xdmf");
        kill(program, SIGKILL);
    };
    const ProgramResult killed = run_sherd({"run", "scene.toml", "-o", "out.h5", "--set", "duration=1000"},
                                           directory.path, {}, kill_it);
    EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
    const ProgramResult next = run_sherd({"run", "scene.toml", "-o", "out.h5", "--force"}, directory.path);
    EXPECT_EQ(next.exit_code, 0) << next.err;
    EXPECT_EQ(Recording(directory.path / "out.h5").end(), "complete");
    EXPECT_FALSE(fs::exists(directory.path / "out.h5.lock"));
}

TEST(OutputLock, OfVariantsIsLookedAtBeforeOneIsRun) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc + "[[variant]]\nname = \"a\"\n[[variant]]\nname = \"b\"\n");
    const std::vector<std::string> all{"run", "scene.toml", "--force"};
    {
        const OutputLock lock(directory.path / "scene-b.h5");  // as in a run of this variant alone
        const auto before = directory.contents();
        const ProgramResult result = run_sherd(all, directory.path);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_TRUE(contains(result.err, "scene-b.h5' is being written by '")) << result.err;
        EXPECT_EQ(directory.contents(), before);
    }
    const OutputLock lock(directory.path / "scene.h5");  // as in a run of all variants, between two variants
    const ProgramResult result = run_sherd(all, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(contains(result.err, "scene.h5' is being written by '")) << result.err;
}

TEST(OutputLock, IsTakenByEveryCommandThatWrites) {
    const TemporaryDirectory directory;
    record(synthetic_run(), directory.path / "run.h5");
    directory.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n");
    directory.write("edges.txt", "0 2\n");
    directory.write("steel.toml", "preset = \"steel\"\nthickness = 0.001\n");
    fs::create_directory(directory.path / "pictures");
    struct Case {
        std::string locked;
        std::vector<std::string> command;
    };
    for (Case writer :
         {Case{"run.svg", {"plot", "run.h5"}}, Case{"run.html", {"view", "run.h5"}},
          Case{"run.obj", {"export", "run.h5", "--to", "obj"}},
          Case{"run.obj", {"export", "run.h5", "--to", "obj", "--frames", "all", "-o", "run.obj"}},
          Case{"run_000001.obj", {"export", "run.h5", "--to", "obj", "--frames", "0:2", "-o", "."}},
          Case{"run.pvd", {"export", "run.h5", "--to", "pvd"}},
          Case{"a.png", {"render", "run.h5", "-o", "a.png", "--size", "8x8", "--samples", "1"}},
          Case{"pictures/run.png", {"render", "run.h5", "-o", "pictures", "--size", "8x8", "--samples", "1"}},
          Case{"opened.obj", {"cut", "square.obj", "--edges", "edges.txt", "-o", "opened.obj"}},
          Case{"probe.h5",
               {"probe", "square.obj", "square.obj", "--material", "steel.toml", "-o", "probe.h5"}}}) {
        writer.command.push_back("--force");
        {
            const OutputLock lock(directory.path / writer.locked);
            const ProgramResult result = run_sherd(writer.command, directory.path);
            EXPECT_EQ(result.exit_code, 2) << writer.command[0] << result.err;
            EXPECT_TRUE(contains(result.err, writer.locked + "' is being written by '")) << result.err;
            EXPECT_TRUE(contains(result.err, std::to_string(getpid()))) << result.err;
        }
        const ProgramResult result = run_sherd(writer.command, directory.path);
        EXPECT_EQ(result.exit_code, 0) << writer.command[0] << result.err;
    }
    for (const auto& [name, content] : directory.contents())
        EXPECT_FALSE(name.ends_with(".lock") || name.ends_with(".part")) << name;
}

// A run must be able to replace a recording that is open elsewhere, whose reader must get an error instead of
// a mixture of two runs.
TEST(OutputLock, ARunIsForcedOverARecordingThatIsBeingRead) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    record(synthetic_run(), directory.path / "scene.h5");
    const Recording reading(directory.path / "scene.h5");
    const int held = open((directory.path / "scene.h5").c_str(), O_RDONLY);
    ASSERT_EQ(flock(held, LOCK_SH), 0) << "as HDF5 does while a file is open";
    const ProgramResult result = run_sherd({"run", "scene.toml", "--force"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    close(held);
    EXPECT_EQ(Recording(directory.path / "scene.h5").end(), "complete");
    try {
        reading.frame(0);
        FAIL() << "the frame is of another run";
    } catch (const Error& error) {
        EXPECT_TRUE(contains(error.what(), "scene.h5' has been replaced by another run")) << error.what();
    }
}

}  // namespace
}  // namespace sherd::test
