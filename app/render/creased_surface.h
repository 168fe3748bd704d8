// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/level_set/signed_distance_grid.h"

namespace sherd {

/// A surface for shading: a point has several corners where its triangles meet at a sharp edge.
struct CreasedSurface {
    std::vector<Eigen::Vector3d> points;   ///< m, of each corner
    std::vector<Eigen::Vector3d> normals;  ///< unit, outward, of each corner
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> point_of;  ///< point of the surface at each corner
};

/// Splits a surface at its sharp edges, where triangles meet at more than some 30 degrees. A corner of a
/// triangle without area, which has no normal, gets z. Triangles keep their order.
CreasedSurface creased(const GridSurface& surface);

/// Returns the same corners and edges for other points of the surface.
CreasedSurface reshaped(CreasedSurface creased, const std::vector<Eigen::Vector3d>& points);

/// Outward normal of a triangle, as long as twice its area.
Eigen::Vector3d face_normal(const GridSurface& surface, const std::array<std::int32_t, 3>& face);

}  // namespace sherd
