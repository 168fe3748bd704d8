// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion.h"

#include <gtest/gtest.h>

#include <numbers>

namespace sherd::test {
namespace {

using std::numbers::pi;

Motion motion(bool smooth) {
    Motion motion;
    motion.place = Eigen::Translation3d(1, 0, 0);
    motion.pivot = Vector3d(1, 0, 0);
    motion.smooth = smooth;
    motion.keys = {{1, Vector3d::Zero(), Vector3d::UnitZ(), 0},
                   {3, Vector3d(0, 0, 4), Vector3d::UnitZ(), 6 * pi},
                   {4, Vector3d(0, 0, 4), -Vector3d::UnitZ(), -5 * pi}};
    return motion;
}

TEST(Motion, RestsBeforeTheFirstAndAfterTheLastKey) {
    for (const bool smooth : {true, false}) {
        const Motion m = motion(smooth);
        EXPECT_TRUE(m.at(0).isApprox(m.place)) << "key 1 leaves it where it was placed";
        EXPECT_TRUE(m.at(1).isApprox(m.place));
        EXPECT_TRUE(m.at(9).isApprox(m.at(4)));
        EXPECT_LT((m.at(4) * Vector3d(0.5, 0, 0) - Vector3d(0.5, 0, 4)).norm(), 1e-12) << "half a turn";
    }
    EXPECT_TRUE(Motion{}.at(3).isApprox(Eigen::Isometry3d::Identity()));
}

// A turntable with three turns in the scene must make them.
TEST(Motion, TurnsAboutThePivotAsOftenAsAsked) {
    const Motion m = motion(false);
    EXPECT_LT((m.at(1.5) * Vector3d(0.5, 0, 0) - Vector3d(1, -0.5, 1)).norm(), 1e-12) << "1.5 pi";
    EXPECT_LT((m.at(1 + 1.0 / 6) * Vector3d(0.5, 0, 0) - Vector3d(1, 0.5, 1.0 / 3)).norm(), 1e-12);
    EXPECT_LT((m.at(3.5) * Vector3d::Zero() - Vector3d(1, 0, 4)).norm(), 1e-12) << "the pivot only rises";
    EXPECT_LT((m.at(3.5) * Vector3d(0.5, 0, 0) - Vector3d(1, -0.5, 4)).norm(), 1e-12) << "5.5 pi";
}

// A turn that is divided into too few parts cuts through the space that it should sweep.
TEST(Motion, SaysHowFarItTurnsBetweenTwoTimes) {
    for (const bool smooth : {true, false}) {
        const Motion m = motion(smooth);
        EXPECT_NEAR(m.turn_between(0, 9), 7 * pi, 1e-12) << "three turns, and half of one back";
        EXPECT_NEAR(m.turn_between(1, 2), 3 * pi, 1e-12);
        EXPECT_NEAR(m.turn_between(2, 3.5), 3.5 * pi, 1e-12);
        EXPECT_EQ(m.turn_between(0, 0.5) + m.turn_between(5, 6), 0);
    }
    EXPECT_EQ(Motion{}.turn_between(0, 1), 0);
    for (const double turn : {0.0, 0.3, 2.0, 1e9}) {
        const int parts = straight_parts(turn);
        EXPECT_GE(parts, 1);
        if (turn > 1e3) continue;  // more than the largest number of parts
        EXPECT_LT(1 - std::cos(turn / parts / 2), 1.0 / 127);
    }
}

TEST(Motion, SmoothStartsAndEndsAtRest) {
    const Motion m = motion(true);
    const auto height = [&](double time) { return m.at(time).translation().z(); };
    EXPECT_NEAR(height(1.001), 0, 1e-5);
    EXPECT_NEAR(height(2), 2, 1e-12);
    EXPECT_NEAR((height(2.001) - height(1.999)) / 0.002, 1.5 * 4 / 2, 1e-5) << "1.5 times the mean speed";
    EXPECT_NEAR(height(2.999), 4, 1e-5);
}

TEST(Motion, RotationsAboutTwoAxesTakeTheShortestWay) {
    Motion m;
    m.smooth = false;
    m.keys = {{0, Vector3d::Zero(), Vector3d::UnitX(), pi / 2},
              {1, Vector3d::Zero(), Vector3d::UnitY(), pi / 2}};
    EXPECT_TRUE(m.at(1).linear().isApprox(Eigen::AngleAxisd(pi / 2, Vector3d::UnitY()).toRotationMatrix()));
    const auto angle = [&](double from, double to) {
        return Eigen::AngleAxisd(m.at(from).linear().transpose() * m.at(to).linear()).angle();
    };
    EXPECT_NEAR(angle(0, 0.5), angle(0, 1) / 2, 1e-12);
}

}  // namespace
}  // namespace sherd::test
