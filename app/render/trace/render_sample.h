// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace sherd {

/// Hash of a number, the same on all machines.
inline std::uint32_t scramble(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;  // a bijection with good avalanche, found by C. Wellons' search
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    return x ^ (x >> 16);
}

/// Number from 0 up to but not including 1, from a hash.
inline float unit_float(std::uint32_t x) {
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

/// Points of a pixel's samples in a unit square, spread evenly: a lattice of generalised golden ratios (M.
/// Roberts, "R2"), shifted by a hash of the pixel and of the purpose of the points.
class SamplePattern {
  public:
    SamplePattern(std::uint32_t pixel, std::uint32_t purpose, int count)
        : count(static_cast<std::uint32_t>(count)), stride(1) {
        const std::uint32_t seed = scramble(pixel * 8 + purpose);
        shift = {unit_float(seed), unit_float(scramble(seed))};
        // Each purpose has its own order: otherwise points of the same sample would fill a part of each
        // square.
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

/// A direction about `axis` (unit), distributed as the cosine of the angle to it.
inline Eigen::Vector3f cosine_direction(const Eigen::Vector3f& axis, const Eigen::Vector2f& point) {
    const Eigen::Vector3f side = axis.unitOrthogonal(), other = axis.cross(side);
    const float radius = std::sqrt(point.x()), angle = 2 * std::numbers::pi_v<float> * point.y();
    return radius * (std::cos(angle) * side + std::sin(angle) * other) +
           std::sqrt(std::max(0.0f, 1 - point.x())) * axis;
}

/// A direction within a cone about `axis` (unit); `width`: tangent of half its angle.
inline Eigen::Vector3f cone_direction(const Eigen::Vector3f& axis, float width,
                                      const Eigen::Vector2f& point) {
    const Eigen::Vector3f side = axis.unitOrthogonal(), other = axis.cross(side);
    const float radius = width * std::sqrt(point.x()), angle = 2 * std::numbers::pi_v<float> * point.y();
    return (axis + radius * (std::cos(angle) * side + std::sin(angle) * other)).normalized();
}

}  // namespace sherd
