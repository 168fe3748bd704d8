// SPDX-License-Identifier: GPL-3.0-or-later
// Runs of all variants of a scene by one command, through the real program: their files and messages.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "app/recording/recording.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/falling_disc.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

const std::string variants_of_disc = falling_disc + R"([[variant]]
name = "slow"
[[variant]]
name = "fast"
sheet.plate.velocity = [0, 0, -1]
[[variant]]
name = "turning"
sheet.plate.spin = [0, 5, 0]
)";

TEST(RunVariants, RunsAllAsIfEachWereRunAlone) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", variants_of_disc);
    const ProgramResult all = run_sherd({"run", "scene.toml", "--set", "seed=4"}, directory.path);
    EXPECT_EQ(all.exit_code, 0) << all.err;
    for (const std::string name : {"slow", "fast", "turning"}) {
        EXPECT_TRUE(contains(all.out, "variant " + name + "\nrun                   complete\n")) << all.out;
        EXPECT_TRUE(contains(all.err, name + ": 100%  step 20")) << all.err;
        const ProgramResult alone = run_sherd(
            {"run", "scene.toml", "--set", "seed=4", "--variant", name, "-o", "alone.h5", "--force"},
            directory.path);
        ASSERT_EQ(alone.exit_code, 0) << alone.err;
        const Recording one(directory.path / "alone.h5"), other(directory.path / ("scene-" + name + ".h5"));
        ASSERT_EQ(one.frame_count(), other.frame_count());
        EXPECT_EQ(one.frame(20).position, other.frame(20).position) << name;
        EXPECT_EQ(other.header().seed, 4);
        EXPECT_TRUE(other.header().scene_text.ends_with("# --variant " + name + "\n# --set seed=4\n"));
    }
    EXPECT_EQ(run_sherd({"run", "scene.toml", "--variant", "slow", "--force"}, directory.path).exit_code, 0)
        << "one variant is named like one of all";
}

TEST(RunVariants, AreWrittenWhereTheOutputSays) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", variants_of_disc);
    EXPECT_EQ(run_sherd({"run", "scene.toml", "-o", "folder"}, directory.path).exit_code, 0);
    EXPECT_TRUE(fs::exists(directory.path / "folder" / "scene-fast.h5"));
    EXPECT_EQ(run_sherd({"run", "scene.toml", "-o", "folder/drop.h5"}, directory.path).exit_code, 0);
    EXPECT_TRUE(fs::exists(directory.path / "folder" / "drop-turning.h5"));
    EXPECT_EQ(run_sherd({"run", "scene.toml", "-o", "missing/folder"}, directory.path).exit_code, 2);

    // If any output file exists, nothing is run, and nothing is replaced.
    for (const char* name : {"drop-slow.h5", "drop-slow.xdmf"}) fs::remove(directory.path / "folder" / name);
    const auto before = directory.contents();
    const ProgramResult kept = run_sherd({"run", "scene.toml", "-o", "folder/drop.h5"}, directory.path);
    EXPECT_EQ(kept.exit_code, 2);
    EXPECT_TRUE(contains(kept.err, "drop-fast.h5' exists")) << kept.err;
    EXPECT_EQ(directory.contents(), before);
    EXPECT_EQ(run_sherd({"run", "scene.toml", "-o", "folder/drop.h5", "--force"}, directory.path).exit_code,
              0);
}

TEST(RunVariants, OneThatFailsDoesNotStopTheOthers) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", variants_of_disc +
                                      "[[variant]]\nname = \"impossible\"\nsheet.plate.spin = [0, 5, 0]\n"
                                      "solver = { max_iterations = 1, tolerance = 1e-30 }\n"
                                      "[[variant]]\nname = \"last\"\n");
    const ProgramResult result = run_sherd({"run", "scene.toml"}, directory.path);
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(contains(result.err, "impossible: sherd: error: step 1, at 0 s")) << result.err;
    EXPECT_TRUE(contains(result.err, "\nsherd: error: 1 of 5 variants failed: impossible\n")) << result.err;
    EXPECT_TRUE(contains(result.out, "variant last\n")) << result.out;
    EXPECT_EQ(Recording(directory.path / "scene-impossible.h5").frame_count(), 1u);
}

TEST(RunVariants, EndTogetherWhenInterrupted) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", variants_of_disc);
    const auto end = [&](pid_t program) {
        for (int i = 0; i < 2000; ++i) {
            if (fs::exists(directory.path / "scene-slow.xdmf") &&
                fs::exists(directory.path / "scene-fast.xdmf"))
                break;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        kill(program, SIGTERM);
    };
    const ProgramResult result =
        run_sherd({"run", "scene.toml", "--set", "duration=1000"}, directory.path, {}, end);
    EXPECT_EQ(result.exit_code, 143) << result.err;
    EXPECT_TRUE(result.err.ends_with(
        "\nsherd: interrupted; of 3 variants 3 were not run to their end; --resume continues them\n"))
        << result.err;
    for (const std::string name : {"slow", "fast"}) {
        EXPECT_GE(Recording(directory.path / ("scene-" + name + ".h5")).frame_count(), 1u);
        EXPECT_TRUE(contains(result.out, "variant " + name + "\nrun                   interrupted\n"))
            << result.out;
    }
    EXPECT_FALSE(fs::exists(directory.path / "scene-turning.h5")) << "it was started after the interruption";
}

}  // namespace
}  // namespace sherd::test
