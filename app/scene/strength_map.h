// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "app/scene/fracture_law.h"
#include "app/scene/map_source.h"

namespace sherd {

/// Strength or toughness of a sheet from place to place.
struct StrengthMap {
    MapSource source;
    /// The factors of the values 0 and 1, linear between them; values above 1 count as 1. Without them the
    /// values are factors themselves.
    std::optional<Eigen::Vector2d> range;
    bool never = false;  ///< instead: nothing breaks where the value is a half or more
    FractureLaw of = FractureLaw::strength;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
