// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace sherd {

/// Returns a hash of a number, equal on all machines.
inline std::uint32_t scramble(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;  // a bijection with good avalanche, found by C. Wellons' search
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    return x ^ (x >> 16);
}

/// Returns the number, from 0 up to but not including 1, that belongs to a hash.
inline float unit_float(std::uint32_t x) {
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

/// Points in a unit square, one for each sample of a pixel, spread evenly: a lattice of generalised golden
/// ratios (M. Roberts, "R2"), shifted by a hash of the pixel and of the purpose of the points.
class SamplePattern {
  public:
    SamplePattern(std::uint32_t pixel, std::uint32_t purpose, int count)
        : count(static_cast<std::uint32_t>(count)), stride(1) {
        const std::uint32_t seed = scramble(pixel * 8 + purpose);
        shift = {unit_float(seed), unit_float(scramble(seed))};
        // Each purpose has its own order of points: with a common order, the points of a sample for different
        // purposes would depend on each other.
        offset = scramble(seed + 1) % this->count;
        stride = this->count * (2 * purpose + 1) / 7 + 1;
        while (std::gcd(stride, this->count) != 1) ++stride;
    }

    Eigen::Vector2f point(int sample) const {
        const auto i = (static_cast<std::uint32_t>(sample) * stride + offset) % count;
        const double x = shift.x() + i * 0.7548776662466927, y = shift.y() + i * 0.5698402909980532;
        return {static_cast<float>(x - std::floor(x)), static_cast<float>(y - std::floor(y))};
    }

  private:
    std::uint32_t count, stride, offset;
    Eigen::Vector2d shift;
};

/// Returns a direction about `axis` (unit). If `point` is uniform in the unit square, the directions are
/// distributed as the cosine of their angle to the axis.
inline Eigen::Vector3f cosine_direction(const Eigen::Vector3f& axis, const Eigen::Vector2f& point) {
    const Eigen::Vector3f side = axis.unitOrthogonal(), other = axis.cross(side);
    const float radius = std::sqrt(point.x()), angle = 2 * std::numbers::pi_v<float> * point.y();
    return radius * (std::cos(angle) * side + std::sin(angle) * other) +
           std::sqrt(std::max(0.0f, 1 - point.x())) * axis;
}

/// Returns a direction within a cone about `axis` (unit). width: tangent of half the angle of the cone.
inline Eigen::Vector3f cone_direction(const Eigen::Vector3f& axis, float width,
                                      const Eigen::Vector2f& point) {
    const Eigen::Vector3f side = axis.unitOrthogonal(), other = axis.cross(side);
    const float radius = width * std::sqrt(point.x()), angle = 2 * std::numbers::pi_v<float> * point.y();
    return (axis + radius * (std::cos(angle) * side + std::sin(angle) * other)).normalized();
}

}  // namespace sherd
