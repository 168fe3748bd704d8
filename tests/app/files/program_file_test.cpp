// SPDX-License-Identifier: GPL-3.0-or-later
// A program started by its bundle's loader must find its own file and launcher, not the loader's.
#include "app/files/program_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

TEST(ProgramFile, OfABundleLiesBesideItsLoader) {
    const TemporaryDirectory directory;
    const fs::path running = directory.path / "libexec" / "sherd";
    fs::create_directory(running.parent_path());
    std::ofstream(running) << "the loader";
    EXPECT_FALSE(bundled_program(running));
    std::ofstream(directory.path / "libexec" / "sherd.program") << "the code";
    const std::optional<BundledProgram> bundled = bundled_program(running);
    ASSERT_TRUE(bundled);
    EXPECT_EQ(bundled->code, directory.path / "libexec" / "sherd.program");
    EXPECT_EQ(bundled->launcher, directory.path / "bin" / "sherd");
}

TEST(ProgramFile, ElsewhereIsTheOneThatRuns) {
    EXPECT_EQ(fs::canonical(program_file()), fs::canonical("/proc/self/exe"));
    EXPECT_EQ(fs::canonical(program_to_start()), fs::canonical("/proc/self/exe"));
    EXPECT_EQ(python_to_start(), "python3");
    EXPECT_TRUE(command_words().ends_with('\0'));
}

}  // namespace
}  // namespace sherd::test
