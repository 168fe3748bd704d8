// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/fragments/fragment_distance.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/broken_grid.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

/// Square with sides of 10 m in two fragments, cut along x = `cut`, m; edges have a length of 10 m / columns.
Snapshot cut_square(Index columns, double cut) {
    Snapshot frame = grid_sheet(columns, columns, 10.0 / columns);
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const Vector3d middle = sherd::columns(frame.rest.position, frame.faces[f]).rowwise().mean();
        frame.face_fragment[f] = middle.x() > cut;
    }
    return frame;
}

// The number of a fragment gives the order of its creation, not its place, and must not count.
TEST(FragmentDistance, OfEqualFragmentsIsNoneWhateverTheirNumbers) {
    const Snapshot frame = cut_square(10, 5);
    Snapshot renamed = frame;
    for (Index& fragment : renamed.face_fragment) fragment = 7 - fragment;
    const FragmentDistance same = fragment_distance(frame, frame), other = fragment_distance(frame, renamed);
    for (const FragmentDistance& distance : {same, other}) {
        EXPECT_NEAR(distance.partition.rand, 1, 1e-12);
        EXPECT_NEAR(distance.partition.adjusted_rand, 1, 1e-12);
        EXPECT_NEAR(distance.partition.variation, 0, 1e-12);
        EXPECT_NEAR(distance.partition.matched(), 1, 1e-12);
        EXPECT_NEAR(distance.gap, 0, 1e-12);
    }
    ASSERT_EQ(other.partition.matches.size(), 2u);
    for (const auto& [first, second, common, over_union] : other.partition.matches) {
        EXPECT_EQ(second, 7 - first);
        EXPECT_NEAR(over_union, 1, 1e-12);
    }
}

// The partitions disagree about two points if one of them is in the strip, a tenth of the square, and the
// other beside it: with the probability 2 * 0.1 * 0.9.
TEST(FragmentDistance, OfACutThatIsMovedByARowOfFacesIsTheStrip) {
    const FragmentDistance distance = fragment_distance(cut_square(10, 5), cut_square(10, 6));
    EXPECT_NEAR(distance.partition.rand, 0.82, 1e-12);
    const double by_chance = 0.5 * 0.52, most = (0.5 + 0.52) / 2, both = 0.25 + 0.01 + 0.16;
    EXPECT_NEAR(distance.partition.adjusted_rand, (both - by_chance) / (most - by_chance), 1e-12);
    const auto term = [](double share) { return share * std::log(share); };
    EXPECT_NEAR(distance.partition.variation,
                2 * term(0.5) + term(0.6) + term(0.4) - 2 * (term(0.5) + term(0.1) + term(0.4)), 1e-12);
    EXPECT_NEAR(distance.partition.matched(), 0.9, 1e-12);
    EXPECT_NEAR(distance.partition.matches[0].over_union, 0.5 / 0.6, 1e-12);
}

TEST(FragmentDistance, DoesNotCareForTheMesh) {
    const FragmentDistance distance = fragment_distance(cut_square(10, 5), cut_square(16, 5));
    EXPECT_NEAR(distance.partition.rand, 1, 1e-12);
    Snapshot moved = cut_square(10, 5);
    moved.rest.position.row(2).array() += 0.25;
    EXPECT_NEAR(fragment_distance(cut_square(10, 5), moved).gap, 0.25, 1e-12);
}

TEST(PartitionDistance, OfOneWholeIsNoneAndOfChanceHasNoAgreement) {
    EXPECT_EQ(partition_distance({{{3, 5}, 1.0}}).adjusted_rand, 1);
    // Two halves are divided across another two: one partition has no information about the other.
    const PartitionDistance across =
        partition_distance({{{0, 0}, 0.25}, {{0, 1}, 0.25}, {{1, 0}, 0.25}, {{1, 1}, 0.25}});
    EXPECT_NEAR(across.adjusted_rand, 0, 1e-12);
    EXPECT_NEAR(across.variation, 2 * std::log(2), 1e-12);
    EXPECT_NEAR(across.rand, 0.5, 1e-12);
    EXPECT_EQ(across.matches.size(), 2u);
}

// The distance must be symmetric, and the index is by its definition the probability that the partitions
// agree about two points.
RC_GTEST_PROP(PartitionDistance, IsTheSameFromEitherSideAndCountsPairs, ()) {
    const auto labels = *rc::gen::resize(
        12, rc::gen::nonEmpty(rc::gen::container<std::vector<std::pair<Index, Index>>>(
                rc::gen::pair(rc::gen::inRange<Index>(0, 4), rc::gen::inRange<Index>(0, 4)))));
    const double share = 1.0 / static_cast<double>(labels.size());
    PartitionOverlap overlap, turned;
    double agreeing = 0;
    for (const auto& [a, b] : labels) {
        overlap[{a, b}] += share, turned[{b, a}] += share;
        for (const auto& [c, d] : labels)
            if ((a == c) == (b == d)) agreeing += share * share;
    }
    const PartitionDistance there = partition_distance(overlap), back = partition_distance(turned);
    RC_ASSERT(std::abs(there.rand - agreeing) < 1e-12);
    RC_ASSERT(std::abs(there.rand - back.rand) < 1e-12);
    RC_ASSERT(std::abs(there.adjusted_rand - back.adjusted_rand) < 1e-9);
    RC_ASSERT(std::abs(there.variation - back.variation) < 1e-12);
    RC_ASSERT(there.adjusted_rand <= 1 + 1e-9);
}

TEST(FragmentDistance, IsOfTheLastFramesOfRecordings) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    record(run, folder.path / "three.h5");
    run.frames.pop_back(), run.steps.pop_back(), run.events.pop_back();
    record(run, folder.path / "two.h5");
    run.frames.clear(), run.steps.clear(), run.events.clear();
    record(run, folder.path / "none.h5");
    const Recording three(folder.path / "three.h5"), two(folder.path / "two.h5");
    const nlohmann::json same = nlohmann::json::parse(distance_json(fragment_distance(three, three)));
    EXPECT_NEAR(same["rand"].get<double>(), 1, 1e-12);
    EXPECT_EQ(same["matches"].size(), 3u);
    EXPECT_LT(fragment_distance(three, two).partition.rand, 0.95);
    EXPECT_NE(distance_text(fragment_distance(three, two)).find("2 fragments"), std::string::npos);
    EXPECT_THROW(fragment_distance(three, Recording(folder.path / "none.h5")), Error);
}

}  // namespace
}  // namespace sherd::test
