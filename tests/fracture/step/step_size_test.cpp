// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/step_size.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace sherd {
namespace {

// Times must be exact to the last bit, so that frames are recorded when the scene asks for them.
TEST(StepSize, KeepsTheNominalStepAndItsExactTimes) {
    StepSize step(1e-4);
    for (int i = 1; i <= 1000; ++i) {
        EXPECT_EQ(step.size(), 1e-4);
        step.advance();
        EXPECT_EQ(step.time(), i * 1e-4);
    }
}

TEST(StepSize, HalvesToASmallestStepAndGrowsBack) {
    StepSize step(1024);
    for (int i = 0; i < StepSize::most_halvings; ++i) EXPECT_TRUE(step.halve());
    EXPECT_EQ(step.size(), 1);
    EXPECT_FALSE(step.halve());
    int steps = 0;
    for (; step.size() < 1024; ++steps) step.advance();
    EXPECT_LE(steps, 6 * StepSize::most_halvings) << "it grows back within a few steps of each size";
    EXPECT_GE(steps, 4 * StepSize::most_halvings) << "not at once: it would fail again";
    EXPECT_EQ(std::fmod(step.time(), 1024), 0) << "where a whole step begins";
}

TEST(StepSize, GrowsAfterFourStepsThatSucceed) {
    StepSize step(1024);
    step.halve();
    step.halve();
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(step.size(), 256);
        step.advance();
    }
    EXPECT_EQ(step.size(), 512);
}

// Explicit steps must all have one length, and end where an implicit step can begin.
TEST(StepSize, KeepsALengthUntilItMayGrow) {
    StepSize step(1024);
    step.keep(6);
    for (int i = 0; i < 64; ++i) {
        EXPECT_EQ(step.size(), 16);
        EXPECT_EQ(step.is_at_whole(), i == 0);
        step.advance();
    }
    EXPECT_TRUE(step.is_at_whole());
    step.resume();
    EXPECT_EQ(step.size(), 1024);
}

// After any failures, no step may cross the end of a nominal step, where frames are recorded.
RC_GTEST_PROP(StepSize, NeverReachesOverAWholeStep, ()) {
    StepSize step(1024);
    for (int i = 0; i < 300; ++i) {
        if (*rc::gen::inRange(0, 3) == 0) step.halve();
        const double before = step.time(), size = step.size();
        RC_ASSERT(std::floor(before / 1024) == std::floor((before + size - 0.5) / 1024));
        step.advance();
        RC_ASSERT(step.time() == before + size);
    }
}

// BDF2 loses its stability where a step is 2.41 times as long as the last one.
RC_GTEST_PROP(StepSize, GrowsByAFactorOf2Point3AtMost, ()) {
    StepSize step(1024);
    double last = step.size();
    for (int i = 0; i < 300; ++i) {
        if (*rc::gen::inRange(0, 8) == 0) step.halve();
        RC_ASSERT(step.size() <= 2.3 * last);
        last = step.size();
        step.advance();
    }
}

}  // namespace
}  // namespace sherd
