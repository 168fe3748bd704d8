// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts at a step that follow an attempt in vain: if they were given up too early, a run would end; if
// they were repeated unchanged, it would never end.
#include "fracture/step/step_policy.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

const Attempt unsolved_step{{Outcome::unsolved}, Urgency::unsolved}, cracked_step{{}, Urgency::crack},
    failed_step{{Outcome::failed, "why"}, Urgency::explicit_failed};

SimulationOptions policy_options(bool alternates) {
    SimulationOptions options;
    options.stepper.step = 1024;
    options.alternates = alternates;
    options.explicit_step = 100;
    return options;
}

/// Retries until nothing is left to try or the scheme changes. Returns the number of halvings.
Index count_halvings(StepPolicy& policy) {
    StepReport report;
    const SchemeChoice before = policy.choice();
    while (policy.choice() == before && policy.retry(unsolved_step, report)) {
    }
    return report.halvings;
}

TEST(StepPolicy, HalvesAStepToTheSmallestOne) {
    StepPolicy policy(policy_options(false), 0);
    policy.begin_step();
    EXPECT_EQ(count_halvings(policy), StepSize::most_halvings);
    EXPECT_EQ(policy.size(), 1);
    StepReport report;
    EXPECT_FALSE(policy.retry(unsolved_step, report));
    EXPECT_EQ(policy.choice().scheme, Scheme::implicit_euler);
}

TEST(StepPolicy, TellsWhyAResultIsInVain) {
    const StepPolicy policy(policy_options(true), 0);
    EXPECT_EQ(policy.urgency({Outcome::too_long}), Urgency::unsolved);
    EXPECT_EQ(policy.urgency({Outcome::passage}), Urgency::passage);
    EXPECT_EQ(policy.urgency({Outcome::failed}), Urgency::unsolved) << "of an implicit step";
}

// Where a scheme has failed, as where sheets overlap, a shorter step cannot help.
TEST(StepPolicy, HasNothingLeftWhereASchemeHasFailed) {
    for (const bool alternates : {false, true}) {
        StepPolicy policy(policy_options(alternates), 0);
        policy.begin_step();
        StepReport report;
        EXPECT_FALSE(policy.retry({{Outcome::failed}, Urgency::unsolved}, report));
    }
}

TEST(StepPolicy, GoesExplicitAndBackWhereThatFails) {
    StepPolicy policy(policy_options(true), 0);
    policy.begin_step();
    StepReport report;
    ASSERT_TRUE(policy.retry(cracked_step, report));
    EXPECT_EQ(policy.choice(), (SchemeChoice{Scheme::explicit_differences, true}));
    EXPECT_EQ(policy.size(), 64);
    EXPECT_EQ(report.urgency, Urgency::crack);
    EXPECT_EQ(policy.urgency(failed_step.result), Urgency::explicit_failed);

    policy.begin_step();
    ASSERT_TRUE(policy.retry(failed_step, report));
    EXPECT_FALSE(policy.is_explicit());
    EXPECT_EQ(policy.size(), 1024);
    EXPECT_EQ(report.urgency, Urgency::explicit_failed);
    EXPECT_EQ(policy.urgency_of({2, true, 0, 0, 1}), Urgency::none)
        << "explicit steps would fail again at once";

    EXPECT_EQ(count_halvings(policy), StepSize::most_halvings);
    EXPECT_EQ(policy.choice(), (SchemeChoice{Scheme::explicit_differences, false})) << "the last resort";
    EXPECT_FALSE(policy.retry(failed_step, report)) << "which is tried once";
}

TEST(StepPolicy, ReturnsToImplicitStepsAfterSomeQuiet) {
    StepPolicy policy(policy_options(true), 0);
    policy.begin_step();
    StepReport report;
    ASSERT_TRUE(policy.retry(cracked_step, report));
    int steps = 0;
    for (; policy.is_explicit() && steps < 1000; ++steps) {
        policy.begin_step();
        policy.advance();
        policy.finish_step({});
    }
    EXPECT_EQ(steps, 4 * 16) << "four whole steps";
    EXPECT_EQ(policy.time(), 4 * 1024);
    EXPECT_EQ(policy.size(), 1024);
}

/// Makes an explicit step after which `time_left` is left. Returns the length of the next one.
double next_length(StepPolicy& policy, double time_left) {
    policy.begin_step();
    policy.advance();
    policy.finish_step({.overload = 1, .fails = true, .time_left = time_left});
    return policy.size();
}

// Most of the explicit time of a broken plate nothing can fail: steps as short as a crack needs them would
// multiply its cost. Steps must be short again at once when something may fail, and must meet the ends of
// whole steps.
TEST(StepPolicy, MakesLongerExplicitStepsWhileNothingWillFail) {
    StepPolicy policy(policy_options(true), 0);
    policy.begin_step();
    StepReport report;
    ASSERT_TRUE(policy.retry(cracked_step, report));
    for (const double length : {64, 128, 256, 512, 1024}) {
        EXPECT_EQ(next_length(policy, 1e9), length) << "at " << policy.time();
    }
    EXPECT_EQ(policy.time(), 1024) << "a longer step begins at a multiple of its length";
    EXPECT_EQ(next_length(policy, 600), 256) << "twice that is less than the time left";
    EXPECT_EQ(next_length(policy, 600), 256);
    EXPECT_EQ(next_length(policy, 0), 64);
    EXPECT_EQ(next_length(policy, 0), 64);
}

}  // namespace
}  // namespace sherd
