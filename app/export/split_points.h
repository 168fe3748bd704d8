// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/write_mesh.h"

namespace sherd {

/// A sheet of which each point has one pair of texture coordinates, as glTF and graphics cards want it.
struct SplitPoints {
    std::vector<std::size_t> points;  ///< those of the sheet, one for each pair that it has
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<Eigen::Vector2d> texture;  ///< of each of `points`; empty: the sheet has none
};

/// Splits the points on seams. Points keep their order, and all copies of one follow the others, in the order
/// of the triangles; a sheet without texture coordinates, or without seams, stays as it is.
SplitPoints split_points(const TriangleSheet& sheet);

}  // namespace sherd
