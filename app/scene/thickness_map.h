// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "app/scene/map_source.h"

namespace sherd {

/// Thickness of a sheet from place to place.
struct ThicknessMap {
    MapSource source;
    /// Thickness for the values 0 and 1, m, linear between them; values above 1 count as 1.
    std::optional<Eigen::Vector2d> range;
    double scale = 1;   ///< m, thickness for the value 1, without range
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
