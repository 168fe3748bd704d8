// SPDX-License-Identifier: GPL-3.0-or-later
// How runs end, through the real program.
#include <gtest/gtest.h>

#include "app/recording/recording.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace sherd {
namespace {

// Hours of a run must not be lost, nor wrong steps recorded, because a later step has no solution.
TEST(Run, ThatCannotGoOnEndsWithARecordingOfWhatWas) {
    const test::TemporaryDirectory directory;
    const auto result =
        test::run_sherd({"run", std::string(SHERD_SCENES) + "/plate_drop.toml", "-o", "run.h5", "--set",
                         "solver.max_iterations=2", "--set", "solver.tolerance=1e-30"},
                        directory.path);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("cannot be solved"), std::string::npos) << result.err;
    const Recording recording(directory.path / "run.h5");
    EXPECT_EQ(recording.frame_count(), 1u);
    EXPECT_TRUE(recording.steps().empty());
    const auto info = test::run_sherd({"info", "run.h5"}, directory.path);
    EXPECT_NE(info.out.find("failed: step 1"), std::string::npos) << info.out;
}

}  // namespace
}  // namespace sherd
