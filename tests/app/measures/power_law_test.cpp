// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/power_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace sherd::test {
namespace {

// A wrong estimator would still give an exponent, which would look like a result.
TEST(PowerLaw, IsTheMostLikelyOneAndItsIntervalThatOfTables) {
    const std::vector<double> values{0.5, 1, std::exp(1.0), std::exp(2.0)};
    const auto law = power_law(values, 1);
    ASSERT_TRUE(law);
    EXPECT_EQ(law->count, 2u);  // values up to 1 do not count
    EXPECT_NEAR(law->exponent, 2.0 / 3, 1e-14);
    // Chi-squared with 4 degrees of freedom: 0.484419 and 11.143287 (tables).
    EXPECT_NEAR(law->interval[0], 2.0 / 3 / 4 * 0.484419, 1e-6);
    EXPECT_NEAR(law->interval[1], 2.0 / 3 / 4 * 11.143287, 1e-6);
}

TEST(PowerLaw, NeedsTwo) {
    EXPECT_FALSE(power_law(std::vector<double>{1, 2}, 1));
    EXPECT_FALSE(power_law({}, 1));
}

// The interval claims to contain the true exponent in 95 of 100 cases: of 1,000 collections with exponent
// 0.7, in 950 +- 7.
TEST(PowerLaw, IntervalHasTheTruthAsOftenAsItSays) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    int right = 0;
    for (int i = 0; i < 1000; ++i) {
        std::vector<double> values(15);
        for (double& value : values) value = 1e-6 * std::pow(1 - uniform(random), -1 / 0.7);
        const auto law = power_law(values, 1e-6);
        right += law->interval[0] <= 0.7 && 0.7 <= law->interval[1];
    }
    EXPECT_NEAR(right, 950, 28);
}

}  // namespace
}  // namespace sherd::test
