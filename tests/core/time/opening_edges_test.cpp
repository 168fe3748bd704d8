// SPDX-License-Identifier: GPL-3.0-or-later
// Cohesive forces of an opening edge: if they took an energy other than that of the crack, cracks would
// propagate with a wrong toughness; if they pushed, the energy would grow.
#include "core/time/opening_edges.h"

#include <gtest/gtest.h>

#include "core/vector.h"

namespace sherd::test {
namespace {

/// Forces [3, 4] that hold the second and the third of four vertices together along x, each by `force`, N.
Positions cohesive_pair(double force) {
    Positions kept = Positions::Zero(3, 4);
    kept(0, 1) = force;
    kept(0, 2) = -force;
    return kept;
}

/// Displacements [3, 4] that move the second and the third vertex apart by `way`, m.
Positions opening_displacement(double way) {
    return -0.5 * way * cohesive_pair(1);
}

}  // namespace
}  // namespace sherd::test

namespace sherd {
namespace {

constexpr double force = 4, time = 1.0 / 12, longest = 1;  // N; s, duration of an opening; s, its limit
const Positions here = Positions::Zero(3, 4);              // m, positions

OpeningEdges by_work() {
    return OpeningEdges(OpeningEdges::Fading::by_work);
}

/// Pulls the vertices apart in steps of `way` (m) until the edge is open, for at most `steps` steps. Returns
/// the work, J.
double pull(OpeningEdges& edges, double way, int steps) {
    double work = 0;
    for (int i = 0; i < steps && !edges.empty(); ++i) {
        Positions before = Positions::Zero(3, 4), after = before;
        edges.add_forces(before);
        edges.fade(test::opening_displacement(way), 1e-6);
        edges.add_forces(after);
        work -= 0.5 * (before + after).cwiseProduct(test::opening_displacement(way)).sum();
    }
    return work;
}

TEST(OpeningEdges, TakeTheirEnergyLessWhatWentAtOnce) {
    OpeningEdges edges = by_work();
    edges.open({7, 0.3, time}, test::cohesive_pair(force), here, 0.1);
    EXPECT_EQ(edges.cohesive_share(7), 1);
    EXPECT_EQ(edges.cohesive_share(8), 0);
    EXPECT_NEAR(pull(edges, 1e-4, 10000), 0.2, 1e-4);
    EXPECT_TRUE(edges.empty());
    EXPECT_EQ(edges.cohesive_share(7), 0);
}

// The share of the force that is left falls with the square root of the share of energy that is left, so
// that the force ends at a finite opening.
TEST(OpeningEdges, FadeByTheRootOfWhatIsLeft) {
    OpeningEdges edges = by_work();
    edges.open({7, 0.2, time}, test::cohesive_pair(force), here, 0);
    const double taken = pull(edges, 1e-5, 3000);
    EXPECT_GT(taken, 0.05);
    EXPECT_NEAR(edges.cohesive_share(7), std::sqrt(1 - taken / 0.2), 1e-9);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), force * edges.cohesive_share(7), 1e-3 * force);
    EXPECT_EQ(now(0, 0), 0);
}

TEST(OpeningEdges, NeverPush) {
    OpeningEdges edges = by_work();
    edges.open({7, 0.2, time}, test::cohesive_pair(force), here, 0);
    edges.fade(test::opening_displacement(-1e-3), 1e-6);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_TRUE(now.isZero(0)) << "what held the edge together would drive it where it closes";
    edges.fade(test::opening_displacement(1e-3), 1e-6);
    edges.add_forces(now);
    EXPECT_GT(now(0, 1), 0) << "and holds it again when it opens";
}

TEST(OpeningEdges, EndAfterTheirTimeAndWhereMoreWentAtOnce) {
    OpeningEdges edges = by_work();
    edges.open({7, 0.2, time}, test::cohesive_pair(force), here, 0.3);
    EXPECT_TRUE(edges.empty());
    edges.open({7, 0.2, time}, test::cohesive_pair(force), here, 0);
    edges.fade(test::opening_displacement(0), longest / 2);
    EXPECT_FALSE(edges.empty());
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), force / 2, 1e-12);
    edges.fade(test::opening_displacement(0), longest);
    EXPECT_TRUE(edges.empty()) << "an edge that rests half open would be glued for ever";
}

// Where two edges open in one step beside small faces, the first may release bending energy that the second
// takes back: the cohesive force of the first edge alone would throw the vertices.
TEST(OpeningEdges, CancelWhatTheNextOpposes) {
    OpeningEdges edges = by_work();
    edges.open({7, 0.2, time}, test::cohesive_pair(force), here, -0.2);
    edges.open({8, 0.2, time}, test::cohesive_pair(-0.75 * force), here, 0.3);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), 0.25 * force, 1e-12);
    EXPECT_NEAR(pull(edges, 1e-4, 10000), 0.25 * 0.4, 1e-4) << "and they take so much less";

    edges.open({9, 0.2, time}, test::cohesive_pair(force), here, 0);
    edges.open({10, 0.2, time}, test::cohesive_pair(-3 * force), here, 0);
    now.setZero();
    edges.add_forces(now);
    EXPECT_NEAR(now(0, 1), -2 * force, 1e-12) << "all of what is kept holds what it held together";
    EXPECT_EQ(edges.cohesive_share(9), 0);
    EXPECT_EQ(edges.cohesive_share(10), 1);
}

TEST(OpeningEdges, KeepWhatTheNextDoesNotOppose) {
    OpeningEdges edges = by_work();
    edges.open({7, 0.2, time}, test::cohesive_pair(force), here, 0);
    edges.open({8, 0.2, time}, test::cohesive_pair(force), here, 0);
    Positions now = Positions::Zero(3, 4);
    edges.add_forces(now);
    EXPECT_EQ(now(0, 1), 2 * force);
}

constexpr double lasts = 1e-5;  // s, time of an opening

StepContext step_at(double begin, double length) {
    StepContext step;
    step.begin = begin;
    step.length = step.lag = length;
    return step;
}

class OpeningEdgesByTime : public testing::Test {
  protected:
    void fail(double energy, double step, double gone = 0) {
        edges.begin_step(step_at(0, step), x);
        edges.shell_changes();
        edges.shell_changed(x);
        edges.open({7, energy, lasts}, test::cohesive_pair(force), x, gone);
    }
    double pull() const {
        Positions gradient = Positions::Zero(3, 4);
        edges.add_gradient(x, gradient);
        return -gradient(0, 1);
    }

    Positions x = Positions::Random(3, 4);
    OpeningEdges edges{OpeningEdges::Fading::by_time};
};

// In a step longer than the opening the cohesive force ends at once, and has taken half of force times
// distance.
TEST_F(OpeningEdgesByTime, TakeHalfOfForceTimesWayInALongStep) {
    fail(1, 1e-3);
    EXPECT_EQ(pull(), 0);
    EXPECT_EQ(edges.cohesive_share(7), 0);
    edges.solved(x + test::opening_displacement(0.05));
    EXPECT_NEAR(edges.taken(), 0.5 * force * 0.05, 1e-12);
    edges.solved(x + test::opening_displacement(0.06));
    EXPECT_NEAR(edges.taken(), 0.5 * force * 0.06, 1e-12) << "the solution goes on";
    edges.finish();
    edges.begin_step(step_at(1e-3, 1e-3), x + test::opening_displacement(0.06));
    edges.solved(x + test::opening_displacement(0.1));
    EXPECT_EQ(edges.taken(), 0);
}

TEST_F(OpeningEdgesByTime, TakeNoMoreThanTheirEnergyLessWhatWentAtOnce) {
    fail(0.3, 1e-3, 0.1);
    edges.solved(x + test::opening_displacement(1));
    EXPECT_NEAR(edges.taken(), 0.2, 1e-12);
}

TEST_F(OpeningEdgesByTime, GiveNothing) {
    fail(1, 1e-3);
    edges.solved(x + test::opening_displacement(-0.05));
    EXPECT_EQ(edges.taken(), 0);
    fail(0.1, 1e-3, 0.1);
    edges.solved(x + test::opening_displacement(0.05));
    EXPECT_EQ(edges.taken(), 0) << "all that it needs has gone at once";
}

// In short steps the forces fade from step to step.
TEST_F(OpeningEdgesByTime, FadeOverShortSteps) {
    const double step = 0.25 * lasts, way = 0.01;
    fail(1, step);
    double taken = 0;
    for (int i = 1; i <= 4; ++i) {
        const double before = 1 - 0.25 * (i - 1), share = 1 - 0.25 * i;
        EXPECT_NEAR(edges.cohesive_share(7), share, 1e-12);
        EXPECT_NEAR(pull(), share * force, 1e-12);
        EXPECT_NEAR(edges.value(x + test::opening_displacement(way)) - edges.value(x), share * force * way,
                    1e-12);
        x = x + test::opening_displacement(way);
        edges.solved(x);
        EXPECT_NEAR(edges.taken(), 0.5 * (before + share) * force * way, 1e-12);
        taken += edges.taken();
        edges.finish();
        edges.begin_step(step_at(i * step, step), x);
    }
    EXPECT_NEAR(taken, 0.5 * force * 4 * way, 1e-12);
    EXPECT_EQ(edges.cohesive_share(7), 0);
}

// Energy that an edge took before another edge failed must not be counted twice.
TEST_F(OpeningEdgesByTime, GoOnWhereTheShellChangesWithinAStep) {
    fail(1, 0.5 * lasts);
    x = x + test::opening_displacement(0.01);
    edges.solved(x);
    const double first = 0.75 * force * 0.01;
    EXPECT_NEAR(edges.taken(), first, 1e-12);
    edges.shell_changes();
    x(0, 1) += 0.3;  // a vertex moves along the sheet
    edges.shell_changed(x);
    EXPECT_NEAR(edges.taken(), first, 1e-12);
    edges.solved(x + test::opening_displacement(0.02));
    EXPECT_NEAR(edges.taken(), first + 0.5 * force * 0.02, 1e-12) << "at the share of the step";
}

// When a step is begun again, edges that failed in it are open, and the energy that they took is dropped.
TEST_F(OpeningEdgesByTime, AStepThatIsBegunAgainHasNoneOfItsEdges) {
    fail(1, 0.25 * lasts);
    edges.solved(x + test::opening_displacement(0.01));
    edges.begin_step(step_at(0, 0.1 * lasts), x);
    EXPECT_EQ(edges.taken(), 0);
    EXPECT_EQ(edges.cohesive_share(7), 0);
    EXPECT_EQ(pull(), 0);
}

// Crack faces that meet again must not be pulled together, and an edge that has taken all its energy must
// not be held.
TEST_F(OpeningEdgesByTime, HoldNothingThatClosesOrHasItsEnergy) {
    for (const double way : {-0.01, 1.0}) {
        fail(0.1, 0.25 * lasts);
        edges.solved(x + test::opening_displacement(way));
        edges.finish();
        EXPECT_EQ(edges.cohesive_share(7), 0);
    }
}

// In statics the cohesive force ends at once.
TEST_F(OpeningEdgesByTime, FadeAtOnceInStatics) {
    StepContext step = step_at(0, 0.1 * lasts);
    step.inertia = 0;
    edges.begin_step(step, x);
    edges.open({7, 1, lasts}, test::cohesive_pair(force), x, 0);
    EXPECT_EQ(edges.cohesive_share(7), 0);
    edges.solved(x + test::opening_displacement(0.05));
    EXPECT_NEAR(edges.taken(), 0.5 * force * 0.05, 1e-12);
}

}  // namespace
}  // namespace sherd
