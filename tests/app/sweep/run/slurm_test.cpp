// SPDX-License-Identifier: GPL-3.0-or-later
// Requests to Slurm: it kills a task that requests too little time or memory, and a task that requests too
// much waits forever.
#include "app/sweep/run/slurm.h"

#include <gtest/gtest.h>

#include "tests/support/program/contains.h"

namespace sherd::test {
namespace {

SlurmJob job_of(std::vector<std::size_t> tasks) {
    return {.chunk = 100,
            .tasks = std::move(tasks),
            .jobs = 2,
            .sweep = {"/opt/sherd", "sweep", "/a b/study.toml"}};
}

TEST(SlurmScript, RunsTheRowsOfEachTask) {
    const std::string script = slurm_script(job_of({0, 1, 2, 5, 7, 8}), {}, {1, 1e9}, "/data/study");
    EXPECT_TRUE(contains(script, "#SBATCH --array=0-2,5,7-8\n")) << script;
    EXPECT_TRUE(contains(script, "#SBATCH --cpus-per-task=2\n")) << script;
    EXPECT_TRUE(contains(script, "#SBATCH --output=/data/study/slurm/%A_%a.log\n")) << script;
    EXPECT_TRUE(
        contains(script,
                 "first=$((SLURM_ARRAY_TASK_ID * 100))\n"
                 "exec /opt/sherd sweep '/a b/study.toml' --jobs 2 --rows $first-$((first + 100 - 1))\n"))
        << script;
    EXPECT_FALSE(contains(script, "partition")) << "what is not given is left to Slurm";
}

TEST(SlurmScript, TimeAndMemoryFollowFromTheCostUnlessTheyAreGiven) {
    const std::string by_cost = slurm_script(job_of({0}), {}, {60, 1e9}, "/data/study");
    EXPECT_TRUE(contains(by_cost, "#SBATCH --time=250\n"))
        << "min: 5 times 50 rows of a minute after each other";
    EXPECT_TRUE(contains(by_cost, "#SBATCH --mem=3600M\n")) << "of two rows at a time";
    const std::string given = slurm_script(
        job_of({0}), {.partition = "p", .account = "a", .time = "1:00:00", .memory = "2G", .chunk = 0},
        {60, 1e9}, "/s");
    for (const char* line : {"--partition=p\n", "--account=a\n", "--time=1:00:00\n", "--mem=2G\n"})
        EXPECT_TRUE(contains(given, line)) << given;
}

TEST(SlurmChunks, TakeAnHourAtMostAndAreAThousandAtMost) {
    EXPECT_EQ(chunk_size(10000, {1, 0}), 720u);
    EXPECT_EQ(chunk_size(10000, {1e5, 0}), 10u) << "in 1000 tasks";
    EXPECT_EQ(chunk_size(3, {1e5, 0}), 1u);
    EXPECT_EQ(chunk_size(3, {0, 0}), 3u);
}

}  // namespace
}  // namespace sherd::test
