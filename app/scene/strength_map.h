// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "app/scene/fracture_law.h"

namespace sherd {

/// Grey values, the mean of the three colours, of a PNG file over the mesh's texture coordinates.
struct StrengthTexture {
    std::filesystem::path path;
};

/// Values of a float grid of an OpenVDB file in the frame of the mesh file.
struct StrengthGrid {
    std::filesystem::path path;
    std::string name = {};  ///< empty: the only float grid
};

/// How strong, or how tough, a sheet is from place to place.
struct StrengthMap {
    std::variant<StrengthTexture, StrengthGrid> kind;
    /// The factors of the values 0 and 1, linear between them; values above 1 count as 1. Without them the
    /// values are factors themselves.
    std::optional<Eigen::Vector2d> range;
    bool never = false;  ///< instead: nothing breaks where the value is a half or more
    FractureLaw of = FractureLaw::strength;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
