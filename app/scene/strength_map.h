// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "meshops/mesh.h"

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

/// How strong a sheet is from place to place.
struct StrengthMap {
    std::variant<StrengthTexture, StrengthGrid> kind;
    /// Factors of the values 0 and 1, linear between them; values above 1 count as 1. None: values are
    /// factors.
    std::optional<Eigen::Vector2d> range;
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// Factors of the strength [E], looked up at the middle of each edge; along a seam of the texture, the mean
/// of what its two faces see. `to_file` leads from the placed mesh to the frame of its file. Throws Error
/// naming the scene's line and key on: a file that is missing, damaged or of another kind, a mesh without
/// texture coordinates, a grid that the file does not hold, and a value that is negative or not finite. A
/// warning says how many edges lie outside a grid's active region.
std::vector<double> map_factors(const StrengthMap& map, const Mesh& placed, const Eigen::Affine3d& to_file,
                                std::vector<std::string>& warnings);

}  // namespace sherd
