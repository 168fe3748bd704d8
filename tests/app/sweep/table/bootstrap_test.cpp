// SPDX-License-Identifier: GPL-3.0-or-later
// Error bars that are too short would make chance look like a result.
#include "app/sweep/table/bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "app/sweep/study/distribution.h"

namespace sherd::test {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// For many values of a normal distribution the interval must be that of theory: 1.96 standard errors to both
// sides of the mean.
TEST(Bootstrap, IntervalIsThatOfTheNormalDistribution) {
    constexpr int count = 400;
    const Distribution normal{Distribution::Kind::normal, 5, 2};
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back(normal.quantile((i + 0.5) / count));
    const MeanEstimate estimate = estimated_mean(values);
    const double error = 1.96 * 2 / std::sqrt(count);
    EXPECT_EQ(estimate.count, 400u);
    EXPECT_NEAR(estimate.mean, 5, 1e-9);
    EXPECT_NEAR(estimate.low, 5 - error, 0.1 * error);
    EXPECT_NEAR(estimate.high, 5 + error, 0.1 * error);
}

TEST(Bootstrap, OfTwoValuesTheIntervalIsFromOneToTheOther) {
    const std::vector<double> values{1, 3};
    const MeanEstimate estimate = estimated_mean(values);
    EXPECT_EQ(estimate.mean, 2);
    EXPECT_EQ(estimate.low, 1);
    EXPECT_EQ(estimate.high, 3);
}

TEST(Bootstrap, WhatIsNoNumberDoesNotCount) {
    const std::vector<double> one{none, 7}, nothing{none};
    EXPECT_EQ(estimated_mean(one).count, 1u);
    EXPECT_EQ(estimated_mean(one).mean, 7);
    EXPECT_TRUE(std::isnan(estimated_mean(one).low)) << "one value says nothing of its scatter";
    EXPECT_EQ(estimated_mean(nothing).count, 0u);
    EXPECT_TRUE(std::isnan(estimated_mean(nothing).mean));
}

}  // namespace
}  // namespace sherd::test
