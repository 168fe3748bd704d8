// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>

namespace sherd {

/// Encoding of an angle between 0 and 180 degrees in a texel.
enum class AxisEncoding {
    hue,    ///< the hue, 0 to 360 degrees, is twice the angle; grey means no direction
    vector  ///< red and green, from zero to full, are cosine and sine of twice the angle, from -1 to 1
};

/// A texture whose texels encode angles, counterclockwise from the direction in which u grows.
struct AxisTexture {
    std::filesystem::path path;
    AxisEncoding encoding = AxisEncoding::hue;
};

/// A direction in the mesh's own frame, which is projected to each face and turned by `degrees`
/// counterclockwise about the face's normal.
struct AxisDirection {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
    double degrees = 0;
};

/// The property attribute::axis of the mesh file's faces, which is projected to each face.
struct AxisField {};

/// Source of a sheet's first material axis. Directions are in the frame of the mesh before it is placed.
struct MaterialAxis {
    std::variant<AxisDirection, AxisTexture, AxisField> kind;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
