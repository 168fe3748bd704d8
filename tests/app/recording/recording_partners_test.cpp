// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings in the programs with which users open them: scripts in tests/partners, run by a Python with h5py
// and by ParaView's Python. If such a program is not installed its test fails (tests/packages.txt names its
// package).
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/recorded_obstacles.h"
#include "tests/support/recording/split_run.h"
#include "tests/support/shell/advanced_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
    return "'" + path.string() + "'";
}

std::string script(const std::string& name) {
    const fs::path tests = fs::path(__FILE__).parent_path().parent_path().parent_path();
    return quoted(tests / "partners" / name);
}

/// Command of a Python that has h5py; empty if there is none. Debian's Python has Debian's h5py, even if
/// another Python is first in the path.
std::string python_with_h5py() {
    for (const char* python : {"python3", "/usr/bin/python3"})
        if (std::system((std::string(python) + " -c 'import h5py' 2>/dev/null").c_str()) == 0) return python;
    return "";
}

void record_copies(const fs::path& file) {
    record(synthetic_run(), file);
}

void record_insertions(const fs::path& file) {
    record(split_run(), file);
}

void record_moves(const fs::path& file) {
    const std::vector<Snapshot> frames = advanced_frames(0, 3, Matrix3d::Identity());
    RecordingWriter writer(file, advanced_header(frames[0]), false);
    for (const Snapshot& frame : frames) writer.append(frame, {}, {});
}

void record_obstacles(const fs::path& file) {
    record_with_obstacles(synthetic_run(), file);
}

void record_modes(const fs::path& file) {
    const TemporaryDirectory directory;
    directory.write("scene.toml",
                    "duration = 1\n[sheet.disc]\nmesh = { generate = \"disc\", radius = 0.1, edge_length = "
                    "0.03 }\nmaterial = { preset = \"steel\" }\n");
    const ProgramResult result =
        run_sherd({"modes", "scene.toml", "-n", "3", "--frames", "8", "-o", file.string()}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
}

/// Test with a recording, whose file name could confuse a reader, and with its content according to h5py:
/// runs in which vertices are copied, faces are split, vertices or obstacles move, and modes of vibration.
class RecordingPartners : public ::testing::TestWithParam<void (*)(const fs::path&)> {
  protected:
    void SetUp() override {
        GetParam()(recording);
        python = python_with_h5py();
        ASSERT_FALSE(python.empty()) << "h5py is missing: install python3-h5py";
        ASSERT_TRUE(passes("check_recording.py", quoted(recording) + " " + quoted(summary)));
    }

    bool passes(const std::string& name, const std::string& arguments) const {
        return std::system((python + " " + script(name) + " " + arguments).c_str()) == 0;
    }

    TemporaryDirectory folder;
    std::string python;
    fs::path recording = folder.path / "a <run> & more: 1.h5";
    fs::path index = fs::path(recording).replace_extension(".xdmf");
    fs::path summary = folder.path / "summary.json";
};

TEST_P(RecordingPartners, H5pyReadsWhatIsPromised) {
    EXPECT_TRUE(fs::exists(summary));
}

TEST_P(RecordingPartners, ParaViewStepsThroughAllFrames) {
    ASSERT_EQ(std::system("command -v pvpython >/dev/null"), 0) << "ParaView is missing: install paraview";
    const fs::path moved = folder.path / "moved";
    fs::create_directory(moved);
    fs::rename(recording, moved / recording.filename());
    fs::rename(index, moved / index.filename());
    EXPECT_EQ(std::system(("pvpython " + script("check_paraview.py") + " " +
                           quoted(moved / index.filename()) + " " + quoted(summary))
                              .c_str()),
              0);
}

INSTANTIATE_TEST_SUITE_P(Copies, RecordingPartners, ::testing::Values(record_copies));
INSTANTIATE_TEST_SUITE_P(Births, RecordingPartners, ::testing::Values(record_insertions));
INSTANTIATE_TEST_SUITE_P(Moves, RecordingPartners, ::testing::Values(record_moves));
INSTANTIATE_TEST_SUITE_P(Modes, RecordingPartners, ::testing::Values(record_modes));
INSTANTIATE_TEST_SUITE_P(Obstacles, RecordingPartners, ::testing::Values(record_obstacles));

// Folder of Sherd's player in Blender, quoted. The player needs Blender only for display.
std::string player() {
    return quoted(fs::path(__FILE__).parent_path() / "../../../app/blender");
}

class SplitPartners : public RecordingPartners {};

TEST_P(SplitPartners, TheBlenderPlayerGivesBlenderWhatWasRecorded) {
    EXPECT_TRUE(passes("check_player.py", player() + " " + quoted(recording)));
}

TEST_P(SplitPartners, ThePagePlaysInsertedFaces) {
    const fs::path page = folder.path / "page.html";
    const ProgramResult result = run_sherd({"view", recording.string(), "-o", page.string()}, folder.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(passes("check_view_births.py", quoted(page) + " " + quoted(recording)));
}

// Vertices that cracks move within the sheet must not move the sheet.
class MovingPartners : public RecordingPartners {};

TEST_P(MovingPartners, TheBlenderPlayerKeepsTheSheetWhereItIs) {
    EXPECT_TRUE(passes("check_player_moves.py", player() + " " + quoted(recording)));
}

// Without the obstacles, fragments in Blender would bounce off nothing.
class ObstaclePartners : public RecordingPartners {};

TEST_P(ObstaclePartners, TheBlenderPlayerMovesThem) {
    EXPECT_TRUE(passes("check_player_obstacles.py", player() + " " + quoted(recording)));
}

INSTANTIATE_TEST_SUITE_P(Obstacles, ObstaclePartners, ::testing::Values(record_obstacles));
INSTANTIATE_TEST_SUITE_P(Moves, MovingPartners, ::testing::Values(record_moves));

INSTANTIATE_TEST_SUITE_P(Births, SplitPartners, ::testing::Values(record_insertions));

}  // namespace
}  // namespace sherd::test
