// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/signed_distance_grid.h"

namespace sherd {

/// A surface as it is lit: a point has several corners where its triangles meet at a sharp edge.
struct CreasedSurface {
    std::vector<Eigen::Vector3d> points;   ///< m, of each corner
    std::vector<Eigen::Vector3d> normals;  ///< unit, outward, of each corner
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> point_of;  ///< of the surface, of each corner
};

/// A corner of a triangle without area, which has no normal, gets z. Triangles that meet at more than some 30
/// degrees keep a sharp edge. The triangles keep their order.
CreasedSurface creased(const GridSurface& surface);

/// The same corners and edges where the surface has these points.
CreasedSurface reshaped(CreasedSurface creased, const std::vector<Eigen::Vector3d>& points);

/// As long as twice the area of the triangle, outward.
Eigen::Vector3d face_normal(const GridSurface& surface, const std::array<std::int32_t, 3>& face);

}  // namespace sherd
