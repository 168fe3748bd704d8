// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/near_tip_fields.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/tips/crack_direction.h"

namespace sherd {
namespace {

const PlaneStress glass_at_tip{70e9, 0.23};
const ModePair mixed_modes{1.3e6, -0.7e6};
constexpr double tip_thickness = 0.004;

std::vector<Vector2d> places_around() {
    std::vector<Vector2d> places;
    for (int i = -8; i <= 8; ++i) {
        const double angle = 0.36 * i;
        places.emplace_back(0.01 * std::cos(angle), 0.01 * std::sin(angle));
    }
    return places;
}

/// Derivative of a function of the place along an axis.
template <class F>
auto derivative(const F& of, const Vector2d& at, int axis) {
    const Vector2d step = 1e-6 * Vector2d::Unit(axis);
    return ((of(at + step) - of(at - step)) / 2e-6).eval();
}

Vector3d stress_there(const Vector2d& at) {
    return membrane_field(glass_at_tip, mixed_modes, at).stress;
}
Vector3d strain_there(const Vector2d& at) {
    return membrane_field(glass_at_tip, mixed_modes, at).strain;
}
Vector2d gradient_there(const Vector2d& at) {
    return membrane_field(glass_at_tip, mixed_modes, at).along_gradient;
}

// From a field that is no equilibrium, or whose displacement does not fit its stress, each contour would
// give other stress intensity factors.
TEST(NearTipFields, MembraneIsInEquilibriumAndCompatible) {
    for (const Vector2d& at : places_around()) {
        const Vector3d x = derivative(stress_there, at, 0), y = derivative(stress_there, at, 1);
        const double scale = stress_there(at).norm() / at.norm();
        EXPECT_NEAR(x[0] + y[2], 0, 1e-6 * scale);
        EXPECT_NEAR(x[2] + y[1], 0, 1e-6 * scale);
        const Vector3d strain = strain_there(at), along = derivative(strain_there, at, 0);
        const Vector2d across = derivative(gradient_there, at, 1);
        const double strains = strain.norm() / at.norm();
        EXPECT_NEAR(gradient_there(at)[0], strain[0], 1e-12 * strain.norm());
        EXPECT_NEAR(along[1], across[1], 1e-6 * strains);
        EXPECT_NEAR(along[2], across[0] + derivative(gradient_there, at, 0)[1], 1e-6 * strains);
    }
}

TEST(NearTipFields, MembraneHasItsFactorsAheadAndFreeCrackFaces) {
    const Vector3d ahead = stress_there({0.01, 0});
    const double unit = 1 / std::sqrt(2 * std::numbers::pi * 0.01);
    EXPECT_NEAR(ahead[1], mixed_modes.first * unit, 1e-9 * ahead.norm());
    EXPECT_NEAR(ahead[2], mixed_modes.second * unit, 1e-9 * ahead.norm());
    for (const double side : {1e-16, -1e-16})
        EXPECT_LT(stress_there({-0.01, side}).tail<2>().norm(), 1e-9 * ahead.norm());
}

PlateField plate_there(const Vector2d& at) {
    return plate_field(glass_at_tip, tip_thickness, mixed_modes, at);
}
/// Moments (00, 11, 01) over the rigidity.
Vector3d moments_there(const Vector2d& at) {
    const Vector3d k = plate_there(at).curvature;
    const double nu = glass_at_tip.poisson;
    return {k[0] + nu * k[1], k[1] + nu * k[0], (1 - nu) / 2 * k[2]};
}
/// Transverse forces over the rigidity.
Vector2d shear_there(const Vector2d& at) {
    const Vector3d x = derivative(moments_there, at, 0), y = derivative(moments_there, at, 1);
    return {x[0] + y[2], x[2] + y[1]};
}

TEST(NearTipFields, PlateIsInEquilibriumAndCompatible) {
    const auto slope = [](const Vector2d& at) { return Vector2d(plate_there(at).along_slope, 0); };
    for (const Vector2d& at : places_around()) {
        const Vector3d curvature = plate_there(at).curvature;
        EXPECT_NEAR(derivative(slope, at, 0)[0], curvature[0], 1e-6 * curvature.norm());
        EXPECT_NEAR(derivative(slope, at, 1)[0], curvature[2] / 2, 1e-6 * curvature.norm());
        const double load = derivative(shear_there, at, 0)[0] + derivative(shear_there, at, 1)[1];
        EXPECT_NEAR(load, 0, 1e-2 * curvature.norm() / at.squaredNorm());
    }
}

// Kirchhoff's free edge: no moment, and a transverse force that is balanced by the change of twist.
TEST(NearTipFields, PlateHasItsFactorAheadAndFreeCrackFaces) {
    const double rigidity = glass_at_tip.young * std::pow(tip_thickness, 3) /
                            (12 * (1 - glass_at_tip.poisson * glass_at_tip.poisson));
    const double surface = 6 * rigidity / (tip_thickness * tip_thickness);
    const Vector3d ahead = moments_there({0.01, 0});
    EXPECT_NEAR(surface * ahead[1], mixed_modes.first / std::sqrt(2 * 0.01), 1e-9 * surface * ahead.norm());
    EXPECT_GT(ahead[2] * mixed_modes.second, 0);
    for (const double side : {2e-6, -2e-6}) {
        const Vector2d crack_face(-0.01, side);
        EXPECT_NEAR(moments_there(crack_face)[1], 0, 1e-3 * ahead.norm());
        const double edge = shear_there(crack_face)[1] + derivative(moments_there, crack_face, 0)[2];
        EXPECT_NEAR(edge, 0, 1e-3 * ahead.norm() / 0.01);
    }
}

constexpr double in_degrees = 180 / std::numbers::pi;

// Values of Erdogan and Sih; a wrong sign would turn cracks the wrong way.
TEST(CrackDirection, MembraneTurnsAsErdoganAndSihSay) {
    EXPECT_EQ(hoop_angle({1, 0}), 0);
    EXPECT_NEAR(hoop_angle({0, 1}) * in_degrees, -70.53, 0.01);
    EXPECT_NEAR(hoop_angle({0, -1}) * in_degrees, 70.53, 0.01);
    EXPECT_NEAR(hoop_angle({1, std::tan(15 / in_degrees)}) * in_degrees, -26.7, 0.1);
    EXPECT_NEAR(hoop_angle({1, std::tan(30 / in_degrees)}) * in_degrees, -43.2, 0.1);
}

TEST(CrackDirection, SearchFindsTheSameWithoutBending) {
    for (const ModePair& modes : {ModePair{1, 0}, {1, 0.3}, {0.2, -1}, {0, 1}}) {
        const HoopDirection found = hoop_direction(glass_at_tip, modes, {});
        EXPECT_NEAR(found.angle, hoop_angle(modes), 1e-6);
        EXPECT_FALSE(found.top);
    }
    EXPECT_NEAR(hoop_direction(glass_at_tip, {2, 0}, {}).intensity, 2, 1e-9);
}

// Bending opens one surface, and a crack under bending of mode I alone must run straight.
TEST(CrackDirection, BendingOpensOneSurfaceAndRunsStraight) {
    for (const double sign : {1.0, -1.0}) {
        const HoopDirection found = hoop_direction(glass_at_tip, {0.1, 0}, {sign, 0});
        EXPECT_NEAR(found.angle, 0, 1e-6);
        EXPECT_EQ(found.top, sign < 0);
        EXPECT_NEAR(found.intensity, 0.1 + std::sqrt(std::numbers::pi), 1e-9);
        EXPECT_LT(sign * hoop_direction(glass_at_tip, {}, {1, sign * 0.3}).angle, -0.1);
    }
}

TEST(NearTipFields, ReleaseIsTheSumOfBothModes) {
    EXPECT_NEAR(membrane_release({2, 0.3}, {3, 4}), 12.5, 1e-12);
    EXPECT_NEAR(plate_release({2, 0.3}, {3, 4}), 25 * std::numbers::pi * 1.3 / (3 * 2 * 3.3), 1e-12);
}

}  // namespace
}  // namespace sherd
