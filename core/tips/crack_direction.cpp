// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/crack_direction.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace sherd {
namespace {

/// Stress component across the ray at `angle`, rad.
double hoop(const Vector3d& stress, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return stress[0] * s * s + stress[1] * c * c - 2 * stress[2] * s * c;
}

/// Hoop stress times sqrt(2 pi r) at a surface; side: 1 at the bottom, -1 at the top.
class HoopStress {
  public:
    HoopStress(const PlaneStress& material, const ModePair& membrane, const ModePair& plate, double side)
        : material(material), membrane(membrane), plate{side * plate.first, side * plate.second} {}

    double operator()(double angle) const {
        const Vector2d at(std::cos(angle), std::sin(angle));
        const auto [young, nu] = material;
        // The thickness cancels: with thickness 1, the strain at the surface is half of the curvature.
        const Vector3d bent = 0.5 * plate_field(material, 1, plate, at).curvature;
        const Vector3d stress =
            young / (1 - nu * nu) *
            Vector3d(bent[0] + nu * bent[1], bent[1] + nu * bent[0], (1 - nu) / 2 * bent[2]);
        return std::sqrt(2 * std::numbers::pi) *
               hoop(stress + membrane_field(material, membrane, at).stress, angle);
    }

  private:
    PlaneStress material;
    ModePair membrane, plate;
};

/// Angle between `low` and `high` at which a function is largest, by golden sections. The function must have
/// a single maximum there.
template <class F>
double angle_of_largest(const F& value, double low, double high) {
    constexpr double golden = std::numbers::phi - 1;
    for (int i = 0; i < 60; ++i) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (value(left) < value(right) ? low : high) = value(left) < value(right) ? left : right;
    }
    return 0.5 * (low + high);
}

}  // namespace

double hoop_angle(const ModePair& membrane) {
    const auto [first, second] = membrane;
    return 2 * std::atan2(-2 * second, first + std::sqrt(first * first + 8 * second * second));
}

HoopDirection hoop_direction(const PlaneStress& material, const ModePair& membrane, const ModePair& plate) {
    constexpr int steps = 180;
    constexpr double step = 2 * std::numbers::pi / steps;
    HoopDirection best{0, -std::numeric_limits<double>::infinity(), false};
    for (const double side : {1.0, -1.0}) {
        const HoopStress stress(material, membrane, plate, side);
        for (int i = 1 - steps / 2; i < steps / 2; ++i)
            if (const double value = stress(i * step); value > best.intensity)
                best = {i * step, value, side < 0};
    }
    const HoopStress stress(material, membrane, plate, best.top ? -1 : 1);
    best.angle = angle_of_largest(stress, best.angle - step, best.angle + step);
    best.intensity = stress(best.angle);
    return best;
}

}  // namespace sherd
