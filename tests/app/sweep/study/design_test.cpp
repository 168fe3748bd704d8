// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a study: a wrong point is a run that was not requested.
#include "app/sweep/study/design.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace sherd::test {
namespace {

using Values = std::vector<std::string>;

Study two_lists(Design design) {
    Study study;
    study.design = design;
    study.parameters = {{"a", {"a={}"}, {"1", "2"}, {}}, {"b", {"b={}"}, {"x", "y"}, {}}};
    return study;
}

TEST(StudyDesign, GridHasEachWithEach) {
    const std::vector<Values> points{{"1", "x"}, {"1", "y"}, {"2", "x"}, {"2", "y"}};
    EXPECT_EQ(design_points(two_lists(Design::grid)), points);
}

TEST(StudyDesign, ZipHasTheFirstOfAllAndTheSecondOfAll) {
    const std::vector<Values> points{{"1", "x"}, {"2", "y"}};
    EXPECT_EQ(design_points(two_lists(Design::zip)), points);
}

TEST(StudyDesign, WithoutParametersThereIsOnePoint) {
    EXPECT_EQ(design_points({}).size(), 1u);
}

Study drawn(Design design, std::int64_t seed) {
    Study study;
    study.design = design;
    study.samples = 50;
    study.seed = seed;
    study.parameters = {{"a", {}, {}, Distribution{Distribution::Kind::uniform, 0, 50}},
                        {"b", {}, {}, Distribution{Distribution::Kind::uniform, 0, 50}},
                        {"c", {}, {"1", "2"}, {}}};
    return study;
}

/// Number of different integer parts in a column of the points.
std::size_t strata(const std::vector<Values>& points, std::size_t column) {
    std::set<double> different;
    for (const Values& point : points) different.insert(std::floor(std::stod(point[column])));
    return different.size();
}

TEST(StudyDesign, LatinHypercubeHasEachStratumOnceInEachParameter) {
    for (const std::int64_t seed : {1, 2, 3}) {
        const std::vector<Values> points = design_points(drawn(Design::latin, seed));
        ASSERT_EQ(points.size(), 50u);
        EXPECT_EQ(strata(points, 0), 50u);
        EXPECT_EQ(strata(points, 1), 50u);
        const auto ones = std::ranges::count(points, "1", [](const Values& point) { return point[2]; });
        EXPECT_EQ(ones, 25) << "of a list each value has an equal share";
    }
}

TEST(StudyDesign, LatinHypercubeShufflesItsParameters) {
    const std::vector<Values> points = design_points(drawn(Design::latin, 1));
    double sum = 0;  // sum of products of the deviations from the mean
    for (const Values& point : points) sum += (std::stod(point[0]) - 25) * (std::stod(point[1]) - 25);
    EXPECT_LT(std::abs(sum / 50), 0.5 * 50 * 50 / 12) << "one parameter tells the other";
}

TEST(StudyDesign, RandomSamplesFollowFromTheSeed) {
    const std::vector<Values> points = design_points(drawn(Design::random, 1));
    EXPECT_EQ(points, design_points(drawn(Design::random, 1)));
    EXPECT_NE(points, design_points(drawn(Design::random, 2)));
    EXPECT_LT(strata(points, 0), 50u) << "nothing keeps samples apart";
}

TEST(StudyDesign, DistributionsHaveTheirQuantiles) {
    using Kind = Distribution::Kind;
    EXPECT_DOUBLE_EQ((Distribution{Kind::uniform, 2, 6}.quantile(0.25)), 3);
    EXPECT_DOUBLE_EQ((Distribution{Kind::log_uniform, 1, 100}.quantile(0.5)), 10);
    EXPECT_NEAR((Distribution{Kind::normal, 10, 2}.quantile(0.975)), 10 + 2 * 1.959963984540054, 1e-12);
    EXPECT_NEAR((Distribution{Kind::lognormal, 10, 1}.quantile(0.5)), 10, 1e-12);
    EXPECT_NEAR((Distribution{Kind::lognormal, 10, 1}.quantile(0.8413447460685429)), 10 * std::exp(1.), 1e-9);
}

}  // namespace
}  // namespace sherd::test
