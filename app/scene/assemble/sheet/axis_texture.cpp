// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/axis_texture.h"

#include <cmath>
#include <numbers>

#include "app/files/picture/image.h"

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

}  // namespace

Vector2d doubled_direction(const Image& image, AxisEncoding encoding, const Vector2d& uv) {
    Vector2d mean = Vector2d::Zero();
    for (const WeightedColour& texel : texels_around(image, uv))
        mean += texel.weight * texel_direction(texel.colour, encoding);
    return mean;
}

}  // namespace sherd
