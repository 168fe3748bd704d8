// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/crack_graph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/measures/cracks/crack_branching.h"
#include "app/measures/cracks/crack_directions.h"
#include "tests/support/recording/broken_grid.h"

namespace sherd::test {
namespace {

constexpr Index squares = 10;

Index at(Index x, Index y) {
    return grid_vertex(squares, x, y);
}

/// Vertices of a path that begins in column and row `from` of the grid and continues by `steps` in columns
/// and rows.
std::vector<Index> path(std::array<Index, 2> from, const std::vector<std::array<Index, 2>>& steps) {
    std::vector<Index> vertices{at(from[0], from[1])};
    for (const auto& [x, y] : steps) {
        from[0] += x, from[1] += y;
        vertices.push_back(at(from[0], from[1]));
    }
    return vertices;
}

std::vector<std::array<Index, 2>> steps(std::size_t count, Index x, Index y) {
    return std::vector<std::array<Index, 2>>(count, std::array{x, y});
}

CrackDirections directions_of(const Snapshot& frame, const std::vector<Vector3d>& axes = {}) {
    return crack_directions(crack_graph(frame), frame.rest, axes);
}

// If a branch did not end at the rim or at a junction, unrelated cracks would count as one.
TEST(CrackGraph, HasABranchFromNodeToNode) {
    Snapshot frame = grid_sheet(squares, squares);
    crack(frame, path({0, 5}, steps(10, 1, 0)));  // from rim to rim
    crack(frame, path({4, 5}, steps(3, 0, 1)));   // from the crack upwards
    const CrackGraph cracks = crack_graph(frame);
    std::vector<std::size_t> lengths;
    for (const CrackBranch& branch : cracks.branches) lengths.push_back(branch.edges.size());
    std::ranges::sort(lengths);
    EXPECT_EQ(lengths, (std::vector<std::size_t>{3, 4, 6}));
    EXPECT_EQ(cracks.degree[at(4, 5)], 3);
    EXPECT_TRUE(cracks.on_rim[at(0, 5)] && cracks.on_rim[at(10, 5)] && !cracks.on_rim[at(4, 5)]);
    EXPECT_DOUBLE_EQ(*tortuosity(cracks, frame.rest), 1);
}

// Two cracks that end at one vertex of the rim, from two directions, must remain two.
TEST(CrackGraph, PartsCracksAtTheRim) {
    Snapshot frame = grid_sheet(squares, squares);
    crack(frame, path({0, 5}, steps(3, 1, 0)));
    crack(frame, path({0, 5}, steps(3, 1, 1)));
    EXPECT_EQ(crack_graph(frame).branches.size(), 2u);
    EXPECT_TRUE(crack_junctions(crack_graph(frame), frame.rest).empty());
}

TEST(CrackGraph, HasClosedLinesOnce) {
    Snapshot frame = grid_sheet(squares, squares);
    auto square = steps(3, 1, 0);
    for (const auto& side : {steps(3, 0, 1), steps(3, -1, 0), steps(3, 0, -1)})
        square.insert(square.end(), side.begin(), side.end());
    crack(frame, path({3, 3}, square));
    const CrackGraph cracks = crack_graph(frame);
    ASSERT_EQ(cracks.branches.size(), 1u);
    EXPECT_TRUE(cracks.branches[0].is_closed());
    EXPECT_EQ(cracks.branches[0].edges.size(), 12u);
    EXPECT_FALSE(tortuosity(cracks, frame.rest));  // a closed line has no chord
}

// No length may be lost or counted twice, whichever edges fail, and a branch must have no node inside.
RC_GTEST_PROP(CrackGraph, BranchesHaveEveryCrackOnce, (const std::vector<std::uint8_t>& failing)) {
    Snapshot frame = grid_sheet(6, squares);
    std::size_t number = 0;
    for (const auto& [a, b, c] : frame.faces)
        for (const auto& side : {std::array{a, b}, std::array{b, c}, std::array{c, a}})
            if (number < failing.size() && failing[number++] % 3 == 0)
                crack(frame, std::vector<Index>(side.begin(), side.end()));
    const CrackGraph cracks = crack_graph(frame);
    std::vector<int> times(cracks.edges.size(), 0);
    for (const CrackBranch& branch : cracks.branches) {
        RC_ASSERT(branch.vertices.size() == branch.edges.size() + 1);
        for (std::size_t i = 0; i < branch.edges.size(); ++i) {
            ++times[branch.edges[i]];
            std::array ends{branch.vertices[i], branch.vertices[i + 1]};
            std::ranges::sort(ends);
            RC_ASSERT(cracks.edges[branch.edges[i]].vertices == ends);
            const bool is_inside = i > 0;
            if (is_inside) RC_ASSERT(cracks.degree[branch.vertices[i]] == 2);
        }
        if (!branch.is_closed())
            for (const Index end : {branch.vertices.front(), branch.vertices.back()})
                RC_ASSERT(cracks.degree[end] != 2 || cracks.on_rim[end]);
    }
    RC_ASSERT(std::ranges::all_of(times, [](int count) { return count == 1; }));
}

TEST(Tortuosity, IsLengthOverChordOfWhatIsNotDust) {
    Snapshot frame = grid_sheet(squares, squares);
    std::vector<std::array<Index, 2>> stairs;
    for (int i = 0; i < 3; ++i) stairs.push_back({1, 0}), stairs.push_back({0, 1});
    crack(frame, path({2, 2}, stairs));
    crack(frame, path({1, 8}, {{1, 0}, {0, 1}}));  // cracks of two edges do not count
    EXPECT_NEAR(*tortuosity(crack_graph(frame), frame.rest), std::sqrt(2), 1e-12);
    crack(frame, path({5, 1}, steps(5, 1, 0)));
    EXPECT_NEAR(*tortuosity(crack_graph(frame), frame.rest), 11 / (3 * std::sqrt(2) + 5), 1e-12);
}

TEST(CrackDirections, AreAgainstTheAxisOfTheFace) {
    Snapshot frame = grid_sheet(squares, squares);
    crack(frame, path({2, 2}, steps(6, 1, 0)));
    const CrackDirections along_x = directions_of(frame);
    EXPECT_NEAR(along_x.length, 6, 1e-12);
    EXPECT_NEAR(std::sin(along_x.mean * std::numbers::pi / 180), 0, 1e-12);
    EXPECT_NEAR(along_x.resultant, 1, 1e-12);
    EXPECT_NEAR(along_x.histogram[0], 1, 1e-12);
    const double turned = std::numbers::pi / 6;
    const std::vector<Vector3d> axes(frame.faces.size(), {std::cos(turned), std::sin(turned), 0});
    const CrackDirections against = directions_of(frame, axes);
    EXPECT_NEAR(against.mean, 150, 1e-10);
    EXPECT_NEAR(against.histogram[10], 1, 1e-12);
    crack(frame, path({5, 4}, steps(6, 0, 1)));  // equal length across: no direction is preferred
    EXPECT_NEAR(directions_of(frame).resultant, 0, 1e-12);
    EXPECT_NEAR(directions_of(frame).histogram[6], 0.5, 1e-12);
}

// Edges have the directions of the mesh: a crack at 45 degrees along edges at 0 and 90 degrees must have
// neither of these directions.
TEST(CrackDirections, AreSmoothedOverAFewEdges) {
    Snapshot frame = grid_sheet(squares, squares);
    std::vector<std::array<Index, 2>> stairs;
    for (int i = 0; i < 8; ++i) stairs.push_back({1, 0}), stairs.push_back({0, 1});
    crack(frame, path({1, 1}, stairs));
    const CrackDirections directions = directions_of(frame);
    EXPECT_NEAR(directions.mean, 45, 1);
    EXPECT_GT(directions.resultant, 0.9);
    EXPECT_NEAR(directions.histogram[2] + directions.histogram[3] + directions.histogram[4], 1, 1e-12);
}

TEST(CrackBranching, HasTheAnglesBetweenNeighbours) {
    Snapshot frame = grid_sheet(squares, squares);
    crack(frame, path({1, 5}, steps(8, 1, 0)));
    crack(frame, path({5, 5}, steps(3, 1, 1)));
    const std::vector<CrackJunction> fork = crack_junctions(crack_graph(frame), frame.rest);
    ASSERT_EQ(fork.size(), 1u);
    EXPECT_EQ(fork[0].branches, 3u);
    EXPECT_LT((fork[0].position - Vector3d(5, 5, 0)).norm(), 1e-15);
    ASSERT_EQ(fork[0].angles.size(), 3u);
    EXPECT_NEAR(fork[0].smallest_angle(), 45, 1e-10);
    EXPECT_NEAR(*std::ranges::max_element(fork[0].angles), 180, 1e-10);
    crack(frame, path({3, 5}, steps(2, 0, 1)));  // too short for a direction, like the rest it leaves
    const std::vector<CrackJunction> both = crack_junctions(crack_graph(frame), frame.rest);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_TRUE(both[0].angles.empty() && both[1].angles.empty());
    EXPECT_FALSE(branching_angle(both));
}

// A crack that crosses another makes a junction of four, wherever it lies in space.
TEST(CrackBranching, IsMeasuredInTheSheet) {
    Snapshot frame = grid_sheet(squares, squares);
    const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    frame.rest.position = turn * frame.rest.position;
    crack(frame, path({1, 5}, steps(8, 1, 0)));
    crack(frame, path({5, 1}, steps(8, 0, 1)));
    const std::vector<CrackJunction> cross = crack_junctions(crack_graph(frame), frame.rest);
    ASSERT_EQ(cross.size(), 1u);
    EXPECT_EQ(cross[0].branches, 4u);
    ASSERT_EQ(cross[0].angles.size(), 4u);
    for (const double angle : cross[0].angles) EXPECT_NEAR(angle, 90, 1e-10);
}

}  // namespace
}  // namespace sherd::test
