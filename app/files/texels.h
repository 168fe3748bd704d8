// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "app/files/image.h"

namespace sherd {

/// A texel, and its weight in a bilinear mean.
struct WeightedColour {
    Eigen::Vector3f colour;
    double weight;
};

/// Returns the four texels around texture coordinates (u, v); their weights add up to one. (0, 0) is the
/// lower left corner of the image and (1, 1) the upper right one. A texel's colour holds at its centre, and
/// the image repeats in both directions.
std::array<WeightedColour, 4> texels_around(const Image& image, const Eigen::Vector2d& uv);

}  // namespace sherd
