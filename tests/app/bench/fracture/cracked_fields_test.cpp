// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the theoretical fields that load the rims of sheets in experiments: a field without equilibrium, or
// of another crack, would make every table wrong.
#include "app/bench/fracture/cracked_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sherd::test {
namespace {

constexpr double half_crack = 0.7, tiny = 1e-6, apart = 1e-5;

/// Divergence of a field of symmetric tensors, by central differences.
template <class Field>
Vector2d divergence(const Field& field, const Vector2d& at) {
    Vector2d sum = Vector2d::Zero();
    for (int axis = 0; axis < 2; ++axis) {
        const Vector2d h = apart * Vector2d::Unit(axis);
        sum += (field(Vector2d(at + h)) - field(Vector2d(at - h))).col(axis) / (2 * apart);
    }
    return sum;
}

TEST(CrackedFields, PulledSheetBalancesAndIsPulledFarAway) {
    for (const double angle : {0.0, 0.5, 1.1}) {
        const PulledSheet sheet(half_crack, angle);
        const auto stress = [&](const Vector2d& at) { return sheet.stress(at); };
        for (const Vector2d& at : {Vector2d(1, 0.4), Vector2d(-0.3, 0.8), Vector2d(0.2, -1.5)})
            EXPECT_LT(divergence(stress, at).norm(), 1e-6) << angle;
        const Eigen::Matrix2d far = Vector2d(0, 1).asDiagonal();
        EXPECT_LT((sheet.stress({300, 400}) - far).norm(), 1e-5);
    }
}

TEST(CrackedFields, PulledSheetHasFreeCrackFacesAndItsFactors) {
    const double angle = 0.5;
    const PulledSheet sheet(half_crack, angle);
    const Vector2d along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
    for (const double side : {-1.0, 1.0}) {
        const Vector2d crack_face = 0.3 * along + side * tiny * across;
        EXPECT_LT((sheet.stress(crack_face) * across).norm(), 1e-4);
    }
    const Vector2d ahead = sheet.stress((half_crack + tiny) * along) * across;
    const double root = std::sqrt(2 * std::numbers::pi * tiny);
    EXPECT_NEAR(root * ahead.dot(across), sheet.opening(), 1e-3);
    EXPECT_NEAR(root * std::abs(ahead.dot(along)), sheet.shear(), 1e-3);
}

TEST(CrackedFields, BentPlateBalancesAndIsBentFarAway) {
    const CrackedPlate plate(half_crack, 0.3);
    const auto moments = [&](const Vector2d& at) { return plate.moments(at); };
    for (const Vector2d& at : {Vector2d(1, 0.4), Vector2d(-0.3, 0.8), Vector2d(0.2, -1.5)})
        EXPECT_LT((divergence(moments, at) - plate.shear(at)).norm(), 1e-6);
    const Eigen::Matrix2d far = Vector2d(0, 1).asDiagonal();
    EXPECT_LT((plate.moments({300, 400}) - far).norm(), 1e-5);
}

// Crack faces must bear no moment and no force: m_yy = 0 and q_y + d m_xy / dx = 0.
TEST(CrackedFields, BentPlateHasFreeCrackFacesAndItsFactor) {
    const CrackedPlate plate(half_crack, 0.3);
    const Vector2d crack_face(0.3, tiny), h(apart, 0);
    EXPECT_NEAR(plate.moments(crack_face)(1, 1), 0, 1e-4);
    EXPECT_NEAR(plate.shear(crack_face).y() +
                    (plate.moments(crack_face + h)(0, 1) - plate.moments(crack_face - h)(0, 1)) / (2 * apart),
                0, 1e-4);
    const double ahead = plate.moments({half_crack + tiny, 0})(1, 1);
    EXPECT_NEAR(std::sqrt(2 * tiny) * ahead, std::sqrt(half_crack), 1e-3);
}

}  // namespace
}  // namespace sherd::test
