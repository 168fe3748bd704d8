// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "app/files/picture/image.h"
#include "app/scene/material_axis.h"

namespace sherd {

/// Returns a vector along (cos, sin) of twice the angle that a texture has at the coordinates `uv`: the
/// bilinear mean of the vectors of four texels (texels_around()). Its length is about 1 where the texels
/// agree, less where they differ, and 0 where there is no direction. Twice the angle is used since opposite
/// directions are equal, so that the mean has no jump where the angle passes 180 degrees.
Eigen::Vector2d doubled_direction(const Image& image, AxisEncoding encoding, const Eigen::Vector2d& uv);

}  // namespace sherd
