// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of the program about failures that the key fracture.smallest forbade.
#include <gtest/gtest.h>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

// A score from rim to rim breaks a disc in two, unless both pieces would be too small: then an edge that must
// not fail holds them together. Without a message a user would take that for physics.
TEST(SmallestPiece, ARunTellsHowManyFailuresItForbade) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", R"(duration = 0.004
[sheet.disc]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.02 }
material = { preset = "glass" }
[[sheet.disc.pin]]
box = [[-0.2, -0.2, -0.1], [-0.06, 0.2, 0.1]]
[[sheet.disc.pin]]
box = [[0.06, -0.2, -0.1], [0.2, 0.2, 0.1]]
[sheet.disc.fracture]
strength = 2e7
score = { line = [[0, -0.1, 0], [0, 0.1, 0]], factor = 0.05 }
[[force.load]]
area = [0, 0, -1e4]
ramp = 0.002
)");
    const auto run = [&](const std::string& smallest) {
        const auto done = run_sherd({"run", "scene.toml", "-o", "run.h5", "--force", "--set",
                                     "sheet.disc.fracture.smallest=" + smallest},
                                    directory.path);
        EXPECT_EQ(done.exit_code, 0) << done.err;
        return done.out;
    };
    const std::string halves = run("0.05"), whole = run("0.2");
    EXPECT_NE(halves.find("fragments             2\n"), std::string::npos) << halves;
    EXPECT_EQ(halves.find("failures forbidden"), std::string::npos) << halves;
    EXPECT_NE(whole.find("fragments             1\n"), std::string::npos) << whole;
    EXPECT_NE(whole.find("failures forbidden"), std::string::npos) << whole;
}

}  // namespace
}  // namespace sherd::test
