// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/geometry/continuous_collision.h"

#include <gtest/gtest.h>

#include "tests/support/contact/contact_pairs.h"

namespace sherd {
namespace {

using test::LongPositions;
using test::Random;

/// Smallest distance of a pair at `samples` + 1 times from 0 to `until`, in long double and without the code
/// under test.
long double sampled_distance(PairKind kind, const PairPositions& x, const PairPositions& displacement,
                             double until, int samples) {
    const LongPositions start = x.cast<long double>(), way = displacement.cast<long double>();
    long double smallest = std::numeric_limits<long double>::infinity();
    for (int i = 0; i <= samples; ++i) {
        const long double time = static_cast<long double>(until) * i / samples;
        smallest = std::min(smallest, test::searched_distance(kind, LongPositions(start + time * way)));
    }
    return smallest;
}

/// Returns the safe fraction of the displacement, after checks that the elements stay apart up to it and, if
/// `tight`, that it does not end long before contact.
double checked_fraction(PairKind kind, const PairPositions& x, const PairPositions& displacement,
                        double minimum, bool tight = true, int samples = 300) {
    const double fraction = safe_fraction(kind, x, displacement, minimum);
    const auto start = static_cast<double>(test::searched_distance(kind, x.cast<long double>()));
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1);
    if (fraction == 0) {
        EXPECT_LE(start, minimum + 1e-11);
        return fraction;
    }
    const auto nearest = static_cast<double>(sampled_distance(kind, x, displacement, fraction, samples));
    EXPECT_GE(nearest, minimum + 0.0999 * (start - minimum) - 1e-12) << x << "\n" << displacement;
    if (tight && fraction < 1) {
        const PairPositions end = x + fraction * displacement;
        EXPECT_LE(static_cast<double>(test::searched_distance(kind, end.cast<long double>())),
                  minimum + 0.151 * (start - minimum) + 1e-12);
    }
    return fraction;
}

// All of contact depends on this property, tested with degenerate positions of both kinds of pairs and
// random motions.
TEST(ContinuousCollision, NeverReportsAStepThatCrosses) {
    for (const PairKind kind : test::pair_kinds) {
        Random random(11);
        int stopped = 0, free = 0;
        for (const PairPositions& x : test::adversarial_pairs(400)) {
            PairPositions displacement = random.matrix<PairPositions>(2);
            if (random.uniform(0, 1) < 0.5) displacement.colwise() += random.matrix<Vector3d>(100);
            const double minimum = random.uniform(0, 1) < 0.5 ? 0 : 1e-3;
            const double fraction = checked_fraction(kind, x, displacement, minimum, false, 100);
            stopped += fraction < 1;
            free += fraction == 1;
        }
        EXPECT_GT(stopped, 50);
        EXPECT_GT(free, 20);
    }
}

// A vertex, or an edge, that moves at 1 km/s in a step of 1e-4 s (by 10 cm), straight or slanted, must stop
// before a sheet of 1 mm.
TEST(ContinuousCollision, StopsAKilometreASecondBeforeAMillimetre) {
    PairPositions triangle, edges;
    triangle << 0, -0.01, 0.02, -0.01, 0, -0.01, 0, 0.02, 0.05, 0, 0, 0;
    edges << -0.01, 0.01, 0, 0, 0, 0, -0.01, 0.01, 0.05, 0.05, 0, 0;
    for (const double sideways : {0.0, 0.01}) {
        PairPositions displacement = PairPositions::Zero();
        displacement.col(0) = Vector3d(sideways, 0, -0.1);
        const double fraction = checked_fraction(PairKind::vertex_triangle, triangle, displacement, 1e-3);
        EXPECT_NEAR(fraction, (0.05 - 1e-3) / 0.1 * 0.9, 0.01);
        displacement.col(1) = displacement.col(0);
        EXPECT_LT(checked_fraction(PairKind::edge_edge, edges, displacement, 1e-3), 0.5);
    }
}

// A head-on hit must not be missed when both elements also move along together.
TEST(ContinuousCollision, CommonMotionDoesNotMatter) {
    PairPositions x;
    x << 0, -1, 2, -1, 0, -1, 0, 2, 0.1, 0, 0, 0;
    PairPositions displacement = PairPositions::Zero();
    displacement(2, 0) = -0.2;
    const double alone = checked_fraction(PairKind::vertex_triangle, x, displacement, 0.01);
    displacement.colwise() += Vector3d(1e4, -3e4, 2e4);
    EXPECT_NEAR(checked_fraction(PairKind::vertex_triangle, x, displacement, 0.01), alone, 1e-6);
    EXPECT_EQ(
        safe_fraction(PairKind::vertex_triangle, x, displacement.rowwise().mean().replicate<1, 4>(), 0.01),
        1);
}

// Motion along a sheet must stop at the minimum distance, but not where it stays further away throughout.
TEST(ContinuousCollision, GrazingMotionPassesWhereThereIsRoom) {
    const auto graze = [](PairKind kind, const PairPositions& at, const PairPositions& way) {
        const double fraction = safe_fraction(kind, at, way, 0.01, 1e-3);
        EXPECT_GE(static_cast<double>(sampled_distance(kind, at, way, fraction, 3000)), 0.011 - 1e-12);
        return fraction;
    };
    PairPositions x, displacement = PairPositions::Zero();
    x << -2, -1, 1, 0, 0, -1, -1, 1, 0.02, 0, 0, 0;
    displacement(0, 0) = 4;
    const double room = graze(PairKind::vertex_triangle, x, displacement);
    EXPECT_EQ(room, 1);
    displacement(2, 0) = -0.0195;  // sinks to the minimum distance half-way
    EXPECT_LT(graze(PairKind::vertex_triangle, x, displacement), 0.6);
    PairPositions edges, along = PairPositions::Zero();
    edges << -3, -2, -1, 1, 0, 0, 0, 0, 0.02, 0.02, 0, 0;  // in line, so that one edge slides over the other
    along.leftCols<2>().row(0).setConstant(6);
    EXPECT_EQ(graze(PairKind::edge_edge, edges, along), 1);
}

// A pair that always stays farther apart than the minimum distance plus twice the clearance must be free to
// move all the way, however far: a pair that is too far apart to be a candidate moves without a test, and
// the result must not depend on whether a pair is tested.
TEST(ContinuousCollision, ALongWayWithRoomIsNotCutShort) {
    PairPositions x, displacement = PairPositions::Zero();
    x << -40, -100, 100, 0, 0, -100, -100, 100, 0.0121, 0, 0, 0;
    displacement(0, 0) = 80;
    EXPECT_EQ(safe_fraction(PairKind::vertex_triangle, x, displacement, 0.01, 1e-3), 1);
}

// Parallel edges that fall onto each other, straight or tilted, or that turn in opposite senses must not
// pass.
TEST(ContinuousCollision, ParallelEdgesMeet) {
    PairPositions x, displacement = PairPositions::Zero();
    x << 0, 1, 0.2, 1.2, 0, 0, 0, 0, 1, 1, 0, 0;
    displacement.leftCols<2>().row(2).setConstant(-2);
    EXPECT_NEAR(checked_fraction(PairKind::edge_edge, x, displacement, 0), 0.45, 0.03);
    displacement(2, 1) = -0.5;
    EXPECT_LT(checked_fraction(PairKind::edge_edge, x, displacement, 0), 1);
    displacement.setZero();
    displacement.row(2) << -1, 1, 1, -1;
    EXPECT_LT(checked_fraction(PairKind::edge_edge, x, displacement, 0), 1);
}

// Elements that touch already must not move, in whatever direction; positions and motions that are not
// finite must not be free, either.
TEST(ContinuousCollision, NothingMovesThatTouches) {
    PairPositions x, displacement = PairPositions::Zero();
    x << 0, -1, 2, -1, 0, -1, 0, 2, 0, 0, 0, 0;
    displacement(2, 0) = 1;
    EXPECT_EQ(safe_fraction(PairKind::vertex_triangle, x, displacement, 0), 0);
    x(2, 0) = 0.5;
    EXPECT_EQ(safe_fraction(PairKind::vertex_triangle, x, displacement, 0.6), 0);
    x(2, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(safe_fraction(PairKind::vertex_triangle, x, displacement, 0), 0);
    x(2, 0) = 0.5;
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        displacement(2, 0) = bad;
        EXPECT_EQ(safe_fraction(PairKind::vertex_triangle, x, displacement, 0), 0);
    }
}

}  // namespace
}  // namespace sherd
