// SPDX-License-Identifier: GPL-3.0-or-later
// Output paths that `sherd run` accepts, and files that remain if it cannot write, through the real program.
#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <string>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

/// Plate in free fall, with one frame per step: no edge fails, and every frame enlarges the recording.
const std::string falling_plate = R"(duration = 0.004
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.01 }
material = { preset = "stoneware" }
[solver]
step = 1e-4
[output]
every = 1e-4
)";

TEST(OutputPath, AnExistingFileIsKeptUnlessForced) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_plate);
    directory.write("out.h5", "the only copy");
    const auto before = directory.contents();
    const ProgramResult kept =
        run_sherd({"run", "scene.toml", "-o", "out.h5", "--set", "duration=0.001"}, directory.path);
    EXPECT_EQ(kept.exit_code, 2) << kept.err;
    EXPECT_NE(kept.err.find("out.h5"), std::string::npos) << kept.err;
    EXPECT_NE(kept.err.find("--force"), std::string::npos) << kept.err;
    EXPECT_EQ(directory.contents(), before);

    const ProgramResult forced = run_sherd(
        {"run", "scene.toml", "-o", "out.h5", "--force", "--set", "duration=0.001"}, directory.path);
    EXPECT_EQ(forced.exit_code, 0) << forced.err;
    EXPECT_EQ(run_sherd({"info", "out.h5"}, directory.path).exit_code, 0);
}

// A single wrong name on the command line would destroy the scene, or a night's recording.
TEST(OutputPath, WhatACommandReadsIsNeverReplaced) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_plate);
    ASSERT_EQ(
        run_sherd({"run", "scene.toml", "-o", "run.h5", "--set", "duration=2e-4"}, directory.path).exit_code,
        0);
    const auto before = directory.contents();
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"run", "scene.toml", "-o", "scene.toml"},
          {"plot", "run.h5", "-o", "run.h5"},
          {"view", "run.h5", "-o", "./run.h5"},
          {"render", "run.h5", "--film", "run.h5"},
          {"export", "run.h5", "--to", "glb", "-o", "run.h5"},
          {"modes", "scene.toml", "-o", "scene.toml"}}) {
        std::vector<std::string> forced = command;
        forced.emplace_back("--force");
        const ProgramResult result = run_sherd(forced, directory.path);
        EXPECT_EQ(result.exit_code, 2) << command[0] << ": " << result.err;
        EXPECT_EQ(directory.contents(), before) << command[0];
    }
}

// No mesh program could open a recording that has the name of a mesh file.
TEST(OutputPath, ANameOfAnotherKindOfFileIsAnErrorWithTheRightOne) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_plate);
    ASSERT_EQ(
        run_sherd({"run", "scene.toml", "-o", "run_0.5", "--set", "duration=2e-4"}, directory.path).exit_code,
        0);
    const auto before = directory.contents();
    for (const auto& [command, words] :
         std::initializer_list<std::pair<std::vector<std::string>, std::string>>{
             {{"run", "scene.toml", "-o", "x.OBJ"}, "-o x.OBJ: a recording is HDF5; name a .h5 file"},
             {{"plot", "run_0.5", "-o", "x.png"}, "-o x.png: plots are SVG; name a .svg file"},
             {{"view", "run_0.5", "-o", "x.svg"}, "-o x.svg: a page is HTML; name a .html file"},
             {{"render", "run_0.5", "-o", "x.jpg"},
              "-o x.jpg: pictures are PNG; name a .png file or a folder, or pass --film FILE.mp4 for a film"},
             {{"export", "run_0.5", "--to", "obj", "-o", "x.glb"},
              "-o x.glb: the extension does not fit --to obj; name a .obj file or a folder"}}) {
        const ProgramResult result = run_sherd(command, directory.path);
        EXPECT_EQ(result.exit_code, 2) << command[0] << ": " << result.err;
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
        EXPECT_EQ(directory.contents(), before) << command[0];
    }
}

TEST(OutputPath, AnImpossiblePathIsAnErrorBeforeTheRun) {
    for (const std::string path : {"missing/out.h5", "scene.toml/out.h5", ".", "/proc/out.h5"}) {
        const TemporaryDirectory directory;
        directory.write("scene.toml", falling_plate);
        const auto before = directory.contents();
        const ProgramResult result = run_sherd({"run", "scene.toml", "-o", path}, directory.path);
        EXPECT_EQ(result.exit_code, 2) << path << ": " << result.err;
        EXPECT_NE(result.err.find(path), std::string::npos) << result.err;
        EXPECT_EQ(directory.contents(), before) << path;
    }
}

TEST(OutputPath, AFullDiskEndsTheRunAndKeepsTheFramesWritten) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_plate);
    ProgramLimits limits;
    limits.file_bytes = 600'000;  // the whole recording has about 1'000'000 bytes
    const ProgramResult full = run_sherd({"run", "scene.toml", "-o", "out.h5"}, directory.path, limits);
    EXPECT_EQ(full.exit_code, 1) << full.out << full.err;
    EXPECT_NE(full.err.find("out.h5"), std::string::npos) << full.err;
    EXPECT_LE(std::filesystem::file_size(directory.path / "out.h5"), *limits.file_bytes);

    const ProgramResult info = run_sherd({"info", "out.h5", "--json"}, directory.path);
    EXPECT_EQ(info.exit_code, 0) << info.err;
    std::smatch frames;
    ASSERT_TRUE(std::regex_search(info.out, frames, std::regex("\"frames\": *([0-9]+)"))) << info.out;
    EXPECT_GE(std::stoi(frames[1]), 1);
    EXPECT_LT(std::stoi(frames[1]), 41) << "the limit was never reached: the test needs a lower one";
}

}  // namespace
}  // namespace sherd::test
