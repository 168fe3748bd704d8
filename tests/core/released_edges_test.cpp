// SPDX-License-Identifier: GPL-3.0-or-later
// Energy that edges take while they open in implicit steps: if it were more than their crack needs, or
// negative, cracks would propagate at a wrong toughness; if it were counted twice, no balance would show it.
#include "core/time/released_edges.h"

#include <gtest/gtest.h>

#include "tests/support/held_pair.h"

namespace sherd {
namespace {

constexpr double release_force = 4, lasts = 1e-5;  // N, s

StepContext step_at(double begin, double length) {
    StepContext step;
    step.begin = begin;
    step.length = step.lag = length;
    return step;
}

class ReleasedEdgesTest : public testing::Test {
  protected:
    void fail(double energy, double step, double gone = 0) {
        edges.begin_step(step_at(0, step), x);
        edges.shell_changes();
        edges.shell_changed(x);
        edges.open({7, energy, lasts}, test::held_together(release_force), x, gone);
    }
    double pull() const {
        Positions gradient = Positions::Zero(3, 4);
        edges.add_gradient(x, gradient);
        return -gradient(0, 1);
    }

    Positions x = Positions::Random(3, 4);
    ReleasedEdges edges;
};

// In a step longer than the opening the cohesive force ends at once, and has taken half of force times
// distance.
TEST_F(ReleasedEdgesTest, TakeHalfOfForceTimesWayInALongStep) {
    fail(1, 1e-3);
    EXPECT_EQ(pull(), 0);
    EXPECT_EQ(edges.held(7), 0);
    edges.solved(x + test::parted_by(0.05));
    EXPECT_NEAR(edges.taken(), 0.5 * release_force * 0.05, 1e-12);
    edges.solved(x + test::parted_by(0.06));
    EXPECT_NEAR(edges.taken(), 0.5 * release_force * 0.06, 1e-12) << "the solution goes on";
    edges.finish();
    edges.begin_step(step_at(1e-3, 1e-3), x + test::parted_by(0.06));
    edges.solved(x + test::parted_by(0.1));
    EXPECT_EQ(edges.taken(), 0);
}

TEST_F(ReleasedEdgesTest, TakeNoMoreThanTheirEnergyLessWhatWentAtOnce) {
    fail(0.3, 1e-3, 0.1);
    edges.solved(x + test::parted_by(1));
    EXPECT_NEAR(edges.taken(), 0.2, 1e-12);
}

TEST_F(ReleasedEdgesTest, GiveNothing) {
    fail(1, 1e-3);
    edges.solved(x + test::parted_by(-0.05));
    EXPECT_EQ(edges.taken(), 0);
    fail(0.1, 1e-3, 0.1);
    edges.solved(x + test::parted_by(0.05));
    EXPECT_EQ(edges.taken(), 0) << "all that it needs has gone at once";
}

// In short steps the forces fade from step to step.
TEST_F(ReleasedEdgesTest, FadeOverShortSteps) {
    const double step = 0.25 * lasts, way = 0.01;
    fail(1, step);
    double taken = 0;
    for (int i = 1; i <= 4; ++i) {
        const double before = 1 - 0.25 * (i - 1), share = 1 - 0.25 * i;
        EXPECT_NEAR(edges.held(7), share, 1e-12);
        EXPECT_NEAR(pull(), share * release_force, 1e-12);
        EXPECT_NEAR(edges.value(x + test::parted_by(way)) - edges.value(x), share * release_force * way,
                    1e-12);
        x = x + test::parted_by(way);
        edges.solved(x);
        EXPECT_NEAR(edges.taken(), 0.5 * (before + share) * release_force * way, 1e-12);
        taken += edges.taken();
        edges.finish();
        edges.begin_step(step_at(i * step, step), x);
    }
    EXPECT_NEAR(taken, 0.5 * release_force * 4 * way, 1e-12);
    EXPECT_EQ(edges.held(7), 0);
}

// Energy taken before another edge failed must not be counted twice.
TEST_F(ReleasedEdgesTest, GoOnWhereTheShellChangesWithinAStep) {
    fail(1, 0.5 * lasts);
    x = x + test::parted_by(0.01);
    edges.solved(x);
    const double first = 0.75 * release_force * 0.01;
    EXPECT_NEAR(edges.taken(), first, 1e-12);
    edges.shell_changes();
    x(0, 1) += 0.3;  // a vertex moves along the sheet
    edges.shell_changed(x);
    EXPECT_NEAR(edges.taken(), first, 1e-12);
    edges.solved(x + test::parted_by(0.02));
    EXPECT_NEAR(edges.taken(), first + 0.5 * release_force * 0.02, 1e-12) << "at the share of the step";
}

// When a step is begun again, its edges are open, and the energy that they took is dropped.
TEST_F(ReleasedEdgesTest, AStepThatIsBegunAgainForgetsItsEdges) {
    fail(1, 0.25 * lasts);
    edges.solved(x + test::parted_by(0.01));
    edges.begin_step(step_at(0, 0.1 * lasts), x);
    EXPECT_EQ(edges.taken(), 0);
    EXPECT_EQ(edges.held(7), 0);
    EXPECT_EQ(pull(), 0);
}

// Crack faces that meet again are not pulled together, and an edge whose energy is complete is not held.
TEST_F(ReleasedEdgesTest, HoldNothingThatClosesOrHasItsEnergy) {
    for (const double way : {-0.01, 1.0}) {
        fail(0.1, 0.25 * lasts);
        edges.solved(x + test::parted_by(way));
        edges.finish();
        EXPECT_EQ(edges.held(7), 0);
    }
}

// In statics the cohesive force ends at once.
TEST_F(ReleasedEdgesTest, FadeAtOnceInStatics) {
    StepContext step = step_at(0, 0.1 * lasts);
    step.inertia = 0;
    edges.begin_step(step, x);
    edges.open({7, 1, lasts}, test::held_together(release_force), x, 0);
    EXPECT_EQ(edges.held(7), 0);
    edges.solved(x + test::parted_by(0.05));
    EXPECT_NEAR(edges.taken(), 0.5 * release_force * 0.05, 1e-12);
}

}  // namespace
}  // namespace sherd
