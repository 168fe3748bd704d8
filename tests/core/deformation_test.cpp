// SPDX-License-Identifier: GPL-3.0-or-later
// Between the samples of a point cache an obstacle must be where an animator expects it, without jumps.
#include "core/deformation.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

/// Deformation of one point that moves along the z axis: it is at the heights `z`, m, at `times`, s.
Deformation heights(std::vector<double> times, const std::vector<float>& z, bool smooth) {
    Deformation deformation{std::move(times), {}, smooth};
    for (const float height : z) deformation.samples.push_back(Eigen::Vector3f(0, 0, height));
    return deformation;
}

double height(const Deformation& deformation, double time) {
    return deformation.at(time)(2, 0);
}

TEST(Deformation, PassesThroughItsSamplesAndRestsOutside) {
    for (const bool smooth : {true, false}) {
        const Deformation d = heights({1, 2, 4}, {0.5F, 1, -2}, smooth);
        EXPECT_EQ(height(d, -3), 0.5);
        EXPECT_EQ(height(d, 1), 0.5);
        EXPECT_EQ(height(d, 2), 1);
        EXPECT_EQ(height(d, 4), -2);
        EXPECT_EQ(height(d, 9), -2);
        EXPECT_EQ(height(heights({3}, {7}, smooth), 5), 7) << "one sample";
    }
}

TEST(Deformation, LinearGoesAtConstantSpeed) {
    const Deformation d = heights({1, 2, 4}, {0.5F, 1, -2}, false);
    EXPECT_NEAR(height(d, 1.25), 0.625, 1e-15);
    EXPECT_NEAR(height(d, 3), -0.5, 1e-15);
}

// A jump of the velocity at a sample would be a blow to everything in contact.
TEST(Deformation, SmoothHasNoJumpsOfItsVelocity) {
    const Deformation d = heights({1, 2, 4, 5}, {0, 1, -2, 3}, true);
    constexpr double h = 1e-6;
    const auto speed = [&](double time) { return (height(d, time + h) - height(d, time)) / h; };
    for (const double time : {1.0, 2.0, 4.0, 5.0}) EXPECT_NEAR(speed(time - h), speed(time), 1e-4);
    EXPECT_NEAR(speed(1), 0, 1e-4) << "it starts from rest";
    EXPECT_NEAR(speed(2), -2.0 / 3, 1e-4) << "that of the neighbours";
}

TEST(Deformation, SmoothKeepsAConstantSpeedBetweenInnerSamples) {
    const Deformation d = heights({0, 1, 2, 3, 4}, {0, 2, 4, 6, 8}, true);
    for (const double time : {1.1, 1.5, 2.0, 2.7, 3.0}) EXPECT_NEAR(height(d, time), 2 * time, 1e-12);
}

}  // namespace
}  // namespace sherd
