// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and pages show the tips of cracks at a time: tips of another step would not be at their cracks.
#include "app/playback/tip_history.h"

#include <gtest/gtest.h>

#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

std::vector<std::pair<Index, std::int64_t>> numbers_and_steps(std::span<const TipRecord> tips) {
    std::vector<std::pair<Index, std::int64_t>> found;
    for (const TipRecord& tip : tips) found.emplace_back(tip.tip, tip.step);
    return found;
}

TEST(TipHistory, HasThoseOfTheLastStepBeforeAMoment) {
    using Tips = std::vector<std::pair<Index, std::int64_t>>;
    SyntheticRun run = synthetic_run();
    add_tips(run);
    const TemporaryDirectory folder;
    record(run, folder.path / "run.h5");
    const TipHistory history(Recording(folder.path / "run.h5"));
    EXPECT_FALSE(history.empty());
    EXPECT_EQ(history.fastest(), 2000);
    EXPECT_EQ(numbers_and_steps(history.at(0, 0)), Tips());
    EXPECT_EQ(numbers_and_steps(history.at(0, 0.035)), (Tips{{0, 3}})) << "between the first two frames";
    EXPECT_EQ(numbers_and_steps(history.at(10, 0.1)), (Tips{{0, 10}, {1, 10}}));
    EXPECT_EQ(numbers_and_steps(history.at(10, 0.1 - 1e-17)), (Tips{{0, 10}, {1, 10}})) << "round-off";
    EXPECT_EQ(numbers_and_steps(history.at(10, 0.145)), (Tips{{1, 14}})) << "the other one has arrested";
    EXPECT_EQ(numbers_and_steps(history.at(20, 0.2)), (Tips{{1, 20}}));
}

TEST(TipHistory, IsEmptyWithoutAny) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    const TipHistory history(Recording(folder.path / "run.h5"));
    EXPECT_TRUE(history.empty());
    EXPECT_TRUE(history.at(10, 0.1).empty());
    EXPECT_EQ(history.fastest(), 0);
}

}  // namespace
}  // namespace sherd::test
