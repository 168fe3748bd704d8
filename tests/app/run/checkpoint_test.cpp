// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/checkpoint.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

#include "tests/support/program/temporary_directory.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

// A program that is killed while it writes a checkpoint leaves an incomplete file, and its lock file. These
// would accumulate in the folder of a sweep, a pair for each such run.
TEST(Checkpoint, WhatAKilledWriterLeavesGoesWithTheCheckpoints) {
    const test::TemporaryDirectory directory;
    const fs::path recording = directory.path / "run.h5";
    for (const fs::path& file : checkpoint_files(recording)) {
        std::ofstream(file) << "one";
        std::ofstream(file.string() + ".part") << "half of one";
        const pid_t writer = fork();
        ASSERT_GE(writer, 0);
        if (writer == 0) {
            auto* const lock = new OutputLock(file);
            _exit(lock == nullptr);
        }
        int status = 1;
        ASSERT_EQ(waitpid(writer, &status, 0), writer);
        ASSERT_EQ(status, 0);
        ASSERT_TRUE(fs::exists(file.string() + ".lock"));
    }
    remove_checkpoints(recording);
    EXPECT_TRUE(fs::is_empty(directory.path));
}

}  // namespace
}  // namespace sherd
