// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/level_set/signed_distance_grid.h"

namespace sherd {

/// A surface for shading. A point of the original surface has several corners, with different normals, where
/// its triangles meet at a sharp edge.
struct CreasedSurface {
    std::vector<Eigen::Vector3d> points;   ///< m, position of each corner
    std::vector<Eigen::Vector3d> normals;  ///< unit, outward normal of each corner
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> point_of;  ///< number of each corner's point in the original surface
};

/// Splits a surface at its sharp edges. A triangle has a sharp corner if its normal differs by more than 30
/// degrees from the mean normal of the triangles around the corner's point. A corner of a triangle without
/// area, which has no normal, gets the normal z. Triangles keep their order.
CreasedSurface creased(const GridSurface& surface);

/// Returns the surface with the same corners and sharp edges, but with other positions of the original
/// surface's points. The normals are computed from these positions.
CreasedSurface reshaped(CreasedSurface creased, const std::vector<Eigen::Vector3d>& points);

/// Returns the outward normal of a triangle; its length is twice the triangle's area.
Eigen::Vector3d face_normal(const GridSurface& surface, const std::array<std::int32_t, 3>& face);

}  // namespace sherd
