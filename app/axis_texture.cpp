// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/axis_texture.h"

#include <cmath>
#include <numbers>

namespace sherd {
namespace {

using Eigen::Vector2d;

/// (cos, sin) of the hue; zero for grey.
Vector2d hue_direction(const Eigen::Vector3f& colour) {
    const float highest = colour.maxCoeff(), chroma = highest - colour.minCoeff();
    if (!(chroma > 0)) return Vector2d::Zero();
    const Eigen::Vector3d c = colour.cast<double>() / chroma;
    const double sixths = colour.x() == highest   ? c.y() - c.z()
                          : colour.y() == highest ? 2 + c.z() - c.x()
                                                  : 4 + c.x() - c.y();
    const double hue = sixths * std::numbers::pi / 3;
    return {std::cos(hue), std::sin(hue)};
}

Vector2d texel_direction(const Eigen::Vector3f& colour, AxisEncoding encoding) {
    if (encoding == AxisEncoding::hue) return hue_direction(colour);
    return {2 * static_cast<double>(colour.x()) - 1, 2 * static_cast<double>(colour.y()) - 1};
}

/// The two texels beside a texture coordinate, and how near it is to the second.
struct Neighbours {
    int low, high;
    double weight;
};

Neighbours neighbours(double coordinate, int count) {
    const double at = (coordinate - std::floor(coordinate)) * count - 0.5, low = std::floor(at);
    const auto wrapped = [count](double index) { return (static_cast<int>(index) + count) % count; };
    return {wrapped(low), wrapped(low + 1), at - low};
}

}  // namespace

Vector2d doubled_direction(const Image& image, AxisEncoding encoding, const Vector2d& uv) {
    const Neighbours x = neighbours(uv.x(), image.width), y = neighbours(uv.y(), image.height);
    const auto texel = [&](int column, int row) {
        return texel_direction(image.colour(column, image.height - 1 - row), encoding);
    };
    const Vector2d lower = (1 - x.weight) * texel(x.low, y.low) + x.weight * texel(x.high, y.low);
    const Vector2d upper = (1 - x.weight) * texel(x.low, y.high) + x.weight * texel(x.high, y.high);
    return (1 - y.weight) * lower + y.weight * upper;
}

}  // namespace sherd
