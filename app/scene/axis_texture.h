// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/image.h"

namespace sherd {

/// How a texel says an angle between 0 and 180 degrees.
enum class AxisEncoding {
    hue,    ///< hue 0 to 360 degrees is twice the angle; grey is no direction
    vector  ///< red and green, 0 to full, are cosine and sine, -1 to 1, of twice the angle
};

/// A texture whose texels are angles, counterclockwise from the direction of u.
struct AxisTexture {
    std::filesystem::path path;
    AxisEncoding encoding = AxisEncoding::hue;
};

/// (cos, sin) of twice the angle at texture coordinates (u, v), up to a length of at most about one, and zero
/// where there is no direction. Doubled, an axis is the same vector when it is turned over, so that the
/// bilinear mean of four texels (texels_around) has no jump where the angle passes 180 degrees.
Eigen::Vector2d doubled_direction(const Image& image, AxisEncoding encoding, const Eigen::Vector2d& uv);

}  // namespace sherd
