// SPDX-License-Identifier: GPL-3.0-or-later
// Cohesive forces of an opening edge: if they took an energy other than that of the crack, cracks would
// propagate at a wrong toughness; if they pushed, the energy would grow.
#include "core/time/opening_edges.h"

#include <gtest/gtest.h>

#include "tests/support/held_pair.h"

namespace sherd {
namespace {

constexpr double force = 4, time = 1.0 / 12, longest = 1;  // N, s

/// Pulls the vertices apart in steps of `way` (m) for at most so many steps. Returns the work, J.
double pull(OpeningEdges& edges, double way, int steps) {
    double work = 0;
    for (int i = 0; i < steps && !edges.empty(); ++i) {
        Positions before = Positions::Zero(3, 4), after = before;
        edges.add_forces(before);
        edges.fade(test::parted_by(way), 1e-6);
        edges.add_forces(after);
        work -= 0.5 * (before + after).cwiseProduct(test::parted_by(way)).sum();
    }
    return work;
}

TEST(OpeningEdges, TakeTheirEnergyLessWhatWentAtOnce) {
    OpeningEdges edges;
    edges.open({7, 0.3, time}, test::held_together(force), 0.1);
    EXPECT_EQ(edges.held(7), 1);
    EXPECT_EQ(edges.held(8), 0);
    EXPECT_NEAR(pull(edges, 1e-4, 10000), 0.2, 1e-4);
    EXPECT_TRUE(edges.empty());
    EXPECT_EQ(edges.held(7), 0);
}

// The share of the force falls with the square root of the share of energy left, so that the force ends at a
// finite opening.
TEST(OpeningEdges, FadeByTheRootOfWhatIsLeft) {
    OpeningEdges edges;
    edges.open({7, 0.2, time}, test::held_together(force), 0);
    const double taken = pull(edges, 1e-5, 3000);
    EXPECT_GT(taken, 0.05);
    EXPECT_NEAR(edges.held(7), std::sqrt(1 - taken / 0.2), 1e-9);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), force * edges.held(7), 1e-3 * force);
    EXPECT_EQ(now(0, 0), 0);
}

TEST(OpeningEdges, NeverPush) {
    OpeningEdges edges;
    edges.open({7, 0.2, time}, test::held_together(force), 0);
    edges.fade(test::parted_by(-1e-3), 1e-6);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_TRUE(now.isZero(0)) << "what held the edge together would drive it where it closes";
    edges.fade(test::parted_by(1e-3), 1e-6);
    edges.add_forces(now);
    EXPECT_GT(now(0, 1), 0) << "and holds it again when it opens";
}

TEST(OpeningEdges, EndAfterTheirTimeAndWhereMoreWentAtOnce) {
    OpeningEdges edges;
    edges.open({7, 0.2, time}, test::held_together(force), 0.3);
    EXPECT_TRUE(edges.empty());
    edges.open({7, 0.2, time}, test::held_together(force), 0);
    edges.fade(test::parted_by(0), longest / 2);
    EXPECT_FALSE(edges.empty());
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), force / 2, 1e-12);
    edges.fade(test::parted_by(0), longest);
    EXPECT_TRUE(edges.empty()) << "an edge that rests half open would be glued for ever";
}

// Where two edges open in one step beside small faces, the first may release bending energy and the next take
// it back: the cohesive force of the first alone would throw the vertices.
TEST(OpeningEdges, CancelWhatTheNextOpposes) {
    OpeningEdges edges;
    edges.open({7, 0.2, time}, test::held_together(force), -0.2);
    edges.open({8, 0.2, time}, test::held_together(-0.75 * force), 0.3);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), 0.25 * force, 1e-12);
    EXPECT_NEAR(pull(edges, 1e-4, 10000), 0.25 * 0.4, 1e-4) << "and they take so much less";

    edges.open({9, 0.2, time}, test::held_together(force), 0);
    edges.open({10, 0.2, time}, test::held_together(-3 * force), 0);
    now.setZero();
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), -2 * force, 1e-12) << "all of what is kept holds what it held together";
    EXPECT_EQ(edges.held(9), 0);
    EXPECT_EQ(edges.held(10), 1);
}

TEST(OpeningEdges, KeepWhatTheNextDoesNotOppose) {
    OpeningEdges edges;
    edges.open({7, 0.2, time}, test::held_together(force), 0);
    edges.open({8, 0.2, time}, test::held_together(force), 0);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_EQ(now(0, 1), 2 * force);
}

}  // namespace
}  // namespace sherd
