// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that are ended by Ctrl-C or SIGTERM: a script that cannot distinguish this end from a failure
// would react wrongly.
#include "app/progress/interruption.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "app/files/disk/output_lock.h"
#include "app/recording/recording.h"
#include "meshops/error.h"
#include "tests/support/program/falling_disc.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

constexpr auto moment = std::chrono::milliseconds(10);

void wait_until_there(const fs::path& file) {
    for (int i = 0; i < 6000 && !fs::exists(file); ++i) std::this_thread::sleep_for(moment);
}

/// Whether a signal is in a set of signals of a program. set: name of a line of the program's status in
/// /proc.
bool has_signal(pid_t program, const std::string& set, int signal) {
    std::ifstream status(fs::path("/proc") / std::to_string(program) / "status");
    for (std::string word; status >> word;)
        if (word == set && status >> word) return (std::stoull(word, nullptr, 16) >> (signal - 1) & 1) != 0;
    return false;
}

/// Waits until a program has a handler for a signal, which shows that its command has begun.
void wait_until_it_catches(pid_t program, int signal) {
    for (int i = 0; i < 6000 && !has_signal(program, "SigCgt:", signal); ++i)
        std::this_thread::sleep_for(moment);
}

/// Sends signals once a file exists: each of them when the signal before it has been delivered.
std::function<void(pid_t)> when_there(const fs::path& file, const std::vector<int>& signals) {
    return [=](pid_t program) {
        wait_until_there(file);
        int before = 0;
        for (const int signal : signals) {
            for (int i = 0; before != 0 && i < 60000 && has_signal(program, "ShdPnd:", before); ++i)
                std::this_thread::sleep_for(moment / 10);
            kill(program, signal);
            before = signal;
        }
    };
}

bool is_written(const fs::path& file) {
    try {
        const OutputLock lock(file);
        return false;
    } catch (const Error&) {
        return true;
    }
}

TEST(Interruption, ARunEndsAfterItsStepAndSaysWhatThereIs) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    for (const int signal : {SIGINT, SIGTERM}) {
        const ProgramResult result =
            run_sherd({"run", "scene.toml", "--force", "--set", "duration=1000"}, directory.path, {},
                      when_there(directory.path / "scene.xdmf", {signal}));
        EXPECT_EQ(result.exit_code, 128 + signal) << result.err;
        const std::string last = result.err.substr(result.err.rfind("\nsherd: ") + 1);
        EXPECT_TRUE(last.starts_with("sherd: interrupted; 'scene.h5' has the run up to ")) << result.err;
        EXPECT_EQ(Recording(directory.path / "scene.h5").end(), "interrupted");
        fs::remove(directory.path / "scene.xdmf");
    }
}

// A second signal must not wait for a step of minutes.
TEST(Interruption, ASecondOneEndsAtOnce) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    const ProgramResult result =
        run_sherd({"run", "scene.toml", "--set", "sheet.plate.mesh.edge_length=0.0015"}, directory.path, {},
                  when_there(directory.path / "scene.xdmf", {SIGINT, SIGTERM}));
    EXPECT_EQ(result.exit_code, 128 + SIGTERM) << result.err;
    EXPECT_TRUE(result.err.ends_with("\nsherd: interrupted\n")) << result.err;
    EXPECT_EQ(Recording(directory.path / "scene.h5").end(), "running") << "the step was waited for";
}

TEST(Interruption, WhatWritesNothingUntilItsEndEndsAtOnce) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    const auto interrupt = [](pid_t program) {
        wait_until_it_catches(program, SIGINT);  // the rest of the command takes minutes
        kill(program, SIGINT);
    };
    const std::vector<std::string> long_ones[] = {
        {"converge", "scene.toml", "--set", "duration=1000", "--set", "sheet.plate.mesh.edge_length=0.01"},
        {"mesh", "scene.toml", "-o", "m.obj", "--set", "sheet.plate.mesh.edge_length=0.0002"},
        {"check", "scene.toml", "--set", "sheet.plate.mesh.edge_length=0.0002"}};
    for (const std::vector<std::string>& command : long_ones) {
        const ProgramResult result = run_sherd(command, directory.path, {}, interrupt);
        EXPECT_EQ(result.exit_code, 128 + SIGINT) << command[0] << result.err;
        EXPECT_TRUE(result.err.ends_with("\nsherd: interrupted\n")) << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_FALSE(fs::exists(directory.path / "m.obj"));
    }
}

// If the runs of variants outlived the program that started them, they would continue unnoticed for hours.
TEST(Interruption, VariantsEndWithTheirParent) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc + "[[variant]]\nname = \"a\"\n[[variant]]\nname = \"b\"\n");
    const auto end = when_there(directory.path / "scene-a.xdmf", {SIGKILL});
    run_sherd({"run", "scene.toml", "--set", "duration=1000"}, directory.path, {}, [&](pid_t program) {
        wait_until_there(directory.path / "scene-b.xdmf");
        end(program);
    });
    for (const std::string name : {"a", "b"}) {
        const fs::path file = directory.path / ("scene-" + name + ".h5");
        for (int i = 0; i < 1000 && is_written(file); ++i) std::this_thread::sleep_for(moment);
        EXPECT_FALSE(is_written(file));
        EXPECT_GE(Recording(file).frame_count(), 1u);
    }
}

}  // namespace
}  // namespace sherd::test
