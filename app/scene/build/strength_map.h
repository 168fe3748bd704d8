// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "app/scene/strength_map.h"
#include "meshops/mesh.h"

namespace sherd {

/// Returns factors of the strength [E], looked up at the middle of each edge, infinite where the map says
/// never; along a seam of the texture they are the mean of what its two faces see. `to_file` leads from the
/// placed mesh to the frame of its file. It throws Error, naming the scene's line and key, on a file that is
/// missing, damaged or of another kind, on a mesh without texture coordinates, on a grid that the file does
/// not hold, and on a value that is negative or not finite. A warning says how many edges lie outside a
/// grid's active region.
std::vector<double> map_factors(const StrengthMap& map, const Mesh& placed, const Eigen::Affine3d& to_file,
                                std::vector<std::string>& warnings);

}  // namespace sherd
