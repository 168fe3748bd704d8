// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using test::Random;
using Pairs = std::vector<std::pair<Index, Index>>;

std::vector<Box> random_boxes(Random& random, int count, double size, double flatness) {
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
        const Vector3d corner = random.matrix<Vector3d>(1), extent = random.matrix<Vector3d>(size);
        box.lower = corner.array().min(corner.array() + extent.array());
        box.upper = corner.array().max(corner.array() + extent.array());
        box.lower[2] *= flatness;
        box.upper[2] *= flatness;
    }
    return boxes;
}

Pairs sorted(Pairs pairs) {
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

// A missed pair is an intersection that nothing later finds; a pair found twice would push twice.
TEST(BoxTree, FindsWhatBruteForceFinds) {
    Random random(2);
    for (const int count : {0, 1, 3, 4, 5, 17, 300})
        for (const double size : {0.01, 0.3, 3.0})
            for (const double flatness : {1.0, 0.0}) {
                const std::vector<Box> a = random_boxes(random, count, size, flatness);
                const std::vector<Box> b = random_boxes(random, count / 2 + 1, size, flatness);
                Pairs both, itself, expected, expected_itself;
                BoxTree(a).meet(BoxTree(b), [&](Index i, Index j) { both.emplace_back(i, j); });
                BoxTree(a).meet_itself([&](Index i, Index j) { itself.push_back(std::minmax(i, j)); });
                for (Index i = 0; i < count; ++i) {
                    for (Index j = 0; j < static_cast<Index>(b.size()); ++j)
                        if (a[i].meets(b[j])) expected.emplace_back(i, j);
                    for (Index j = i + 1; j < count; ++j)
                        if (a[i].meets(a[j])) expected_itself.emplace_back(i, j);
                }
                EXPECT_EQ(sorted(both), expected);
                EXPECT_EQ(sorted(itself), expected_itself);
            }
}

// A known division of boxes into the nodes of a tree is used again while the boxes move. It must not lose a
// pair, and must be replaced when the boxes are elsewhere: otherwise all nodes would overlap, and a search
// would take as long as comparing all boxes.
TEST(BoxTree, FindsTheSameInAKnownDivision) {
    Random random(3);
    std::vector<Box> boxes = random_boxes(random, 300, 0.1, 1);
    const auto pairs_of = [](const BoxTree& tree) {
        Pairs pairs;
        tree.meet_itself([&](Index i, Index j) { pairs.push_back(std::minmax(i, j)); });
        return sorted(pairs);
    };
    BoxTree::Division known;
    EXPECT_EQ(pairs_of(BoxTree(boxes, known)), pairs_of(BoxTree(boxes)));
    const std::vector<Index> at_first = known.element;
    EXPECT_EQ(at_first, BoxTree(boxes).order());
    for (Box& box : boxes) {
        const Eigen::Array3d way = random.matrix<Vector3d>(0.05).array();
        box = {box.lower + way, box.upper + way};
    }
    EXPECT_EQ(pairs_of(BoxTree(boxes, known)), pairs_of(BoxTree(boxes)));
    EXPECT_EQ(known.element, at_first);
    EXPECT_NE(known.element, BoxTree(boxes).order());
    boxes = random_boxes(random, 300, 0.1, 1);
    EXPECT_EQ(pairs_of(BoxTree(boxes, known)), pairs_of(BoxTree(boxes)));
    EXPECT_EQ(known.element, BoxTree(boxes).order());
    boxes.pop_back();
    EXPECT_EQ(pairs_of(BoxTree(boxes, known)), pairs_of(BoxTree(boxes)));
    EXPECT_EQ(known.element.size(), boxes.size());
}

// Touching boxes meet; boxes with equal centres, which cannot be split, must not be lost.
TEST(BoxTree, BoxesThatTouchOrCoincideMeet) {
    const Box unit{Eigen::Array3d(0, 0, 0), Eigen::Array3d(1, 1, 1)};
    const Box beside{Eigen::Array3d(1, 1, 1), Eigen::Array3d(2, 2, 2)};
    EXPECT_TRUE(unit.meets(beside));
    int count = 0;
    BoxTree(std::vector<Box>(20, unit)).meet_itself([&](Index, Index) { ++count; });
    EXPECT_EQ(count, 190);
}

TEST(BoxTree, ElementsAreInTheBoxesOfTheirVertices) {
    std::vector<Box> vertices(3);
    for (int i = 0; i < 3; ++i) vertices[i] = {Eigen::Array3d(i, -i, 0), Eigen::Array3d(i + 1, -i, 0.5)};
    const std::vector<Box> edges = element_boxes<2>(vertices, {{0, 2}, {1, 2}});
    EXPECT_TRUE((edges[0].lower == Eigen::Array3d(0, -2, 0)).all());
    EXPECT_TRUE((edges[0].upper == Eigen::Array3d(3, 0, 0.5)).all());
    EXPECT_TRUE((edges[1].lower == Eigen::Array3d(1, -2, 0)).all());
}

}  // namespace
}  // namespace sherd
