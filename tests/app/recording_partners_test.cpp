// SPDX-License-Identifier: GPL-3.0-or-later
// A recording in the programs that people open it with: scripts in tests/partners, run by h5py's Python and
// by ParaView's. A partner that is not installed makes its test fail (tests/packages.txt names its package).
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

std::string quoted(const fs::path& path) {
    return "'" + path.string() + "'";
}

std::string script(const std::string& name) {
    return quoted(fs::path(__FILE__).parent_path().parent_path() / "partners" / name);
}

/// Debian's Python sees Debian's h5py, whatever other Python stands first in the path.
std::string python_with_h5py() {
    for (const char* python : {"python3", "/usr/bin/python3"})
        if (std::system((std::string(python) + " -c 'import h5py' 2>/dev/null").c_str()) == 0) return python;
    return "";
}

/// A recording, with a name that has all that could confuse a reader, and what h5py finds in it.
class RecordingPartners : public ::testing::Test {
  protected:
    void SetUp() override {
        record(synthetic_run(), recording);
        const std::string python = python_with_h5py();
        ASSERT_FALSE(python.empty()) << "h5py is missing: install python3-h5py";
        ASSERT_EQ(std::system((python + " " + script("check_recording.py") + " " + quoted(recording) + " " +
                               quoted(summary))
                                  .c_str()),
                  0);
    }

    TemporaryDirectory folder;
    fs::path recording = folder.path / "a <run> & more: 1.h5";
    fs::path index = fs::path(recording).replace_extension(".xdmf");
    fs::path summary = folder.path / "summary.json";
};

TEST_F(RecordingPartners, H5pyReadsWhatIsPromised) {
    EXPECT_TRUE(fs::exists(summary));
}

TEST_F(RecordingPartners, ParaViewStepsThroughAllFrames) {
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

}  // namespace
}  // namespace sherd::test
