// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "app/files/picture/image.h"
#include "app/scene/material_axis.h"

namespace sherd {

/// Returns (cos, sin) of twice the angle at texture coordinates (u, v), up to a length of at most about one,
/// and zero where there is no direction. With the doubled angle, opposite directions are the same vector, so
/// that the bilinear mean of four texels (texels_around) has no jump where the angle passes 180 degrees.
Eigen::Vector2d doubled_direction(const Image& image, AxisEncoding encoding, const Eigen::Vector2d& uv);

}  // namespace sherd
