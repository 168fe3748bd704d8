// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/motion_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using test::Random;

Positions points(Random& random, Index count, double size) {
    Positions x(3, count);
    for (double& entry : x.reshaped()) entry = random.uniform(-size, size);
    return x;
}

/// Bound on the relative motion, m, of any two of the vertices `vertices`.
double bound(const MotionCells& cells, const std::vector<Box>& boxes, const std::vector<Index>& vertices) {
    Box all;
    for (const Index v : vertices) all.include(boxes[cells.of(v)]);
    return spread(all);
}

// With too small a bound contacts would be missed.
TEST(MotionCells, BoundWhatAnyTwoVerticesMove) {
    Random random(4);
    for (const Index count : {1, 15, 49, 400}) {
        MotionCells cells;
        cells.cover(points(random, count, 1));
        cells.cover(points(random, count + 30, 1));  // some vertices are newer than the cells
        const Positions motions = points(random, count + 30, 0.1);
        const std::vector<Box> boxes = cells.boxes(motions);
        for (int sample = 0; sample < 50; ++sample) {
            std::vector<Index> some;
            for (int i = 0; i < 6; ++i)
                some.push_back(std::min(count + 29, static_cast<Index>(random.uniform(0, count + 30))));
            for (const Index a : some)
                for (const Index b : some)
                    EXPECT_LE((motions.col(a) - motions.col(b)).norm(),
                              bound(cells, boxes, some) * (1 + 1e-15));
        }
    }
}

// With larger bounds than necessary, a search would test pairs in a sheet that moves as a whole, or far away
// from a part that moves by itself.
TEST(MotionCells, TellApartWhatIsFarFromEachOther) {
    Random random(5);
    const Index count = 10'000;
    const Positions x = points(random, count, 1);
    MotionCells cells;
    cells.cover(x);
    Positions motions = Positions::Zero(3, count).colwise() + Vector3d(3, 2, 1);
    for (Index v = 0; v < count; ++v)
        if (x(0, v) > 0.5) motions.col(v) = random.matrix<Vector3d>(1);
    const std::vector<Box> boxes = cells.boxes(motions);
    for (Index v = 0; v < count; ++v)
        if (x(0, v) < 0) {
            EXPECT_EQ(spread(boxes[cells.of(v)]), 0) << v;
        }
}

TEST(MotionCells, VerticesThatComeLaterStandAlone) {
    Random random(6);
    MotionCells cells;
    cells.cover(points(random, 100, 1));
    cells.cover(points(random, 120, 1));
    const std::vector<Box> boxes = cells.boxes(points(random, 120, 1));
    for (Index v = 100; v < 120; ++v) EXPECT_EQ(spread(boxes[cells.of(v)]), 0);
}

}  // namespace
}  // namespace sherd
