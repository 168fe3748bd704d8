// SPDX-License-Identifier: GPL-3.0-or-later
// Begin and end of explicit steps: if they began too late an impact would be damped, and if they never ended
// a run of seconds would take days.
#include "fracture/step/step_pace.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

constexpr StepActivity calm{0.1, false, 0, 0.1, 10}, strike{0.1, false, 0.2, 0.1, 10},
    ringing{0.6, false, 0, 1, 10}, stressed{0.8, false, 0, 0, 10}, cracking{1.1, true, 0, 0, 10};

TEST(StepPace, ExplicitStepsBeginWithAStrikeStressOrACrack) {
    const StepPace pace;
    EXPECT_EQ(pace.urgency_of(calm), Urgency::none);
    EXPECT_EQ(pace.urgency_of(ringing), Urgency::none) << "what rings in flight touches nothing";
    EXPECT_EQ(pace.urgency_of(strike), Urgency::strike);
    EXPECT_EQ(pace.urgency_of(stressed), Urgency::stress);
    EXPECT_EQ(pace.urgency_of(cracking), Urgency::crack);
}

// Energies are large or small beside the largest energy of the run, also when little is left of it: a small
// fragment that lands must not count as an impact.
TEST(StepPace, WhatIsMuchIsOfTheLargestEnergy) {
    StepPace pace;
    StepActivity large = calm;
    large.energy = 1000;
    pace.implicit_finished(large, true);
    EXPECT_EQ(pace.urgency_of(strike), Urgency::none);
}

/// Makes explicit steps, four to a whole one, until implicit steps shall follow. Returns the number of whole
/// steps; 0 if it exceeds 1000.
int whole_steps_until_quiet(StepPace& pace, const StepActivity& step) {
    for (int whole = 1; whole <= 1000; ++whole)
        for (int i = 0; i < 4; ++i)
            if (pace.explicit_finished(step, i == 3)) return whole;
    return 0;
}

TEST(StepPace, ExplicitStepsEndWhenNothingHasHappenedForSomeWholeSteps) {
    StepPace pace;
    pace.begin_explicit();
    for (int i = 0; i < 10; ++i) EXPECT_FALSE(pace.explicit_finished(cracking, true));
    EXPECT_FALSE(pace.explicit_finished(strike, false));
    EXPECT_FALSE(pace.explicit_finished(ringing, true)) << "it has struck since the last whole step";
    EXPECT_EQ(whole_steps_until_quiet(pace, ringing), 4);
}

// A shard that lies on a slope has all its energy stored in contact, in every step, which must not count as
// an impact.
TEST(StepPace, ExplicitStepsEndWhereSomethingLiesOrIsPressed) {
    StepPace pace;
    pace.begin_explicit();
    const StepActivity lies{0.1, false, 10, 0, 10}, bounces{0.1, false, 9, 0, 10};
    EXPECT_EQ(whole_steps_until_quiet(pace, lies), 4);
    pace.begin_explicit();
    for (int i = 0; i < 10; ++i) {
        EXPECT_FALSE(pace.explicit_finished(lies, true));
        EXPECT_FALSE(pace.explicit_finished(bounces, false));
    }
}

// A run that begins at rest has no large energy to compare with: the smallest bounce would count as an
// impact.
TEST(StepPace, BouncesOfLittleEnergyAreNoBlows) {
    StepPace pace(0.5);
    EXPECT_EQ(pace.urgency_of(strike), Urgency::none);
    pace.begin_explicit();
    EXPECT_EQ(whole_steps_until_quiet(pace, strike), 4);
}

// The first implicit steps damp remaining vibrations; this dissipation must not count as an impact.
TEST(StepPace, FirstImplicitStepsCalmWhatRings) {
    StepPace pace;
    pace.begin_explicit();
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(pace.urgency_of(strike), Urgency::none);
        EXPECT_EQ(pace.urgency_of(cracking), Urgency::crack) << "but for what fails";
        pace.implicit_finished(strike, true);
    }
    EXPECT_EQ(pace.urgency_of(strike), Urgency::strike);
}

// If implicit steps turn out urgent at once, again and again, each further attempt is likely to be wasted:
// attempts must become rarer.
TEST(StepPace, TrialsInVainAreMadeLessOften) {
    StepPace pace;
    pace.begin_explicit();
    for (const int quiet : {4, 8, 16, 32, 64, 64}) {
        EXPECT_EQ(whole_steps_until_quiet(pace, calm), quiet);
        pace.implicit_finished(calm, true);
        pace.begin_explicit();
    }
    whole_steps_until_quiet(pace, calm);
    for (int i = 0; i < 10; ++i) pace.implicit_finished(calm, true);
    pace.begin_explicit();
    EXPECT_EQ(whole_steps_until_quiet(pace, calm), 4) << "the last trial was not in vain";
}

// Explicit steps that failed would fail again at once; but if no explicit steps ever followed, all later
// cracks would propagate in implicit steps.
TEST(StepPace, ImplicitStepsGoOnForSomeWholeStepsWhereExplicitOnesCannot) {
    StepPace pace;
    for (const int whole_steps : {4, 8, 16, 32, 64, 64}) {
        pace.begin_explicit();
        pace.begin_forced_implicit();
        for (int whole = 0; whole < whole_steps; ++whole)
            for (int i = 0; i < 4; ++i) {
                EXPECT_TRUE(pace.must_be_implicit());
                EXPECT_EQ(pace.urgency_of(cracking), Urgency::none);
                pace.implicit_finished(cracking, i == 3);
            }
        EXPECT_FALSE(pace.must_be_implicit());
        EXPECT_EQ(pace.urgency_of(cracking), Urgency::crack);
    }
    pace.begin_forced_implicit();
    pace.begin_explicit();
    EXPECT_FALSE(pace.must_be_implicit()) << "nothing else was left";
}

}  // namespace
}  // namespace sherd
