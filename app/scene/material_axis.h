// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>

namespace sherd {

/// Encoding of an angle between 0 and 180 degrees in a texel.
enum class AxisEncoding {
    hue,    ///< hue 0 to 360 degrees is twice the angle; grey is no direction
    vector  ///< red and green, 0 to full, are cosine and sine, -1 to 1, of twice the angle
};

/// A texture whose texels are angles, counterclockwise from the direction of u.
struct AxisTexture {
    std::filesystem::path path;
    AxisEncoding encoding = AxisEncoding::hue;
};

/// A direction in the mesh's own frame, projected to the surface and turned counterclockwise about the face's
/// normal.
struct AxisDirection {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
    double degrees = 0;
};

/// The property attribute::axis of the mesh file, projected to the surface.
struct AxisField {};

/// Source of a sheet's first material axis. Directions are those of the mesh before it is placed.
struct MaterialAxis {
    std::variant<AxisDirection, AxisTexture, AxisField> kind;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

}  // namespace sherd
