// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/strength.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/generate/generate.h"

namespace sherd {
namespace {

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

double variance(const std::vector<double>& values) {
    const double m = mean(values);
    double sum = 0;
    for (const double value : values) sum += (value - m) * (value - m);
    return sum / static_cast<double>(values.size());
}

TEST(Strength, TellsTheRangeOfItsFactorsAndHowManyNeverFail) {
    const double never = std::numeric_limits<double>::infinity();
    const auto range = factor_range(std::vector{never, 0.5, 2.0, never, 1.0});
    ASSERT_TRUE(range);
    EXPECT_EQ(range->least, 0.5);
    EXPECT_EQ(range->most, 2);
    EXPECT_EQ(range->never, 2u);
    EXPECT_FALSE(factor_range(std::vector{never}));
    EXPECT_FALSE(factor_range({}));
}

// An edge at an angle to the axis is pulled perpendicular to itself. Between the directions of both axes,
// the strength must follow Hankinson's formula.
TEST(Strength, DependsOnTheDirectionOfThePull) {
    Strength strength;
    strength.along = 4;
    strength.across = 1;
    EXPECT_DOUBLE_EQ(directional_strength(strength, 0), 1);
    EXPECT_DOUBLE_EQ(directional_strength(strength, std::numbers::pi / 2), 4);
    EXPECT_NEAR(directional_strength(strength, std::numbers::pi / 4), 1.6, 1e-14);
    EXPECT_NEAR(directional_strength(strength, -std::numbers::pi / 4), 1.6, 1e-14) << "either way round";
    EXPECT_EQ(directional_strength(uniform_strength(0.3), 0.7), 0.3) << "to the last bit";
    EXPECT_EQ(directional_strength(Strength{}, 0.7), std::numeric_limits<double>::infinity());
}

// Mean and scatter must be those of the distribution, whatever the mesh.
TEST(Weibull, HasMeanOneAndTheScatterOfItsModulus) {
    for (const double edge_length : {0.02, 0.01}) {
        const Mesh mesh = generate_rectangle(1, 1, {edge_length, Layout::delaunay, 1});
        for (const double modulus : {3.0, 12.0}) {
            const std::vector<double> factors = weibull_factors(mesh, {.modulus = modulus, .seed = 5});
            ASSERT_EQ(factors.size(), mesh.number_of_edges());
            const double first = std::tgamma(1 + 1 / modulus), second = std::tgamma(1 + 2 / modulus);
            const double expected = second / (first * first) - 1;
            EXPECT_NEAR(mean(factors), 1, 4 * std::sqrt(expected / static_cast<double>(factors.size())));
            EXPECT_NEAR(variance(factors), expected, 0.1 * expected);
            EXPECT_GT(*std::min_element(factors.begin(), factors.end()), 0);
        }
    }
}

/// Mean, over 400 draws, of the smallest strength factor of a mesh's hinges.
double mean_weakest(const Mesh& mesh, double modulus, double area) {
    double sum = 0;
    constexpr int draws = 400;
    for (unsigned seed = 1; seed <= draws; ++seed) {
        const std::vector<double> factors =
            weibull_factors(mesh, {.modulus = modulus, .area = area, .seed = seed});
        double weakest = std::numeric_limits<double>::infinity();
        for (const Edge edge : mesh.edges())
            if (!mesh.is_border(edge)) weakest = std::min(weakest, factors[edge]);
        sum += weakest;
    }
    return sum / draws;
}

// With a reference area, a patch of that area must have a mean strength factor of 1 on coarse and fine
// meshes.
TEST(Weibull, KeepsThePatchStrengthOnEveryMesh) {
    for (const double edge_length : {0.04, 0.01}) {
        const Mesh patch = generate_rectangle(0.2, 0.2, {edge_length, Layout::delaunay, 3});
        EXPECT_NEAR(mean_weakest(patch, 6, 0.04), 1, 0.03) << "edges of " << edge_length;
    }
}

TEST(Weibull, IsTheSameForTheSameSeedOnly) {
    const Mesh mesh = generate_rectangle(1, 1, {0.1, Layout::delaunay, 1});
    EXPECT_EQ(weibull_factors(mesh, {.seed = 3}), weibull_factors(mesh, {.seed = 3}));
    EXPECT_NE(weibull_factors(mesh, {.seed = 3}), weibull_factors(mesh, {.seed = 4}));
}

}  // namespace
}  // namespace sherd
