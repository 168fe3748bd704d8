// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "app/render/trace/render_scene.h"
#include "meshops/level_set/signed_distance_grid.h"

namespace sherd {

/// sRGB, 0xRRGGBB.
inline constexpr std::uint32_t obstacle_grey = 0x8c8f93;

/// Mesh of an obstacle: grey, with sharp edges where its triangles meet at more than some 30 degrees. pose:
/// from its own frame to space; origin: m, subtracted from all positions.
RenderMesh obstacle_solid(const GridSurface& surface, const Eigen::Isometry3d& pose,
                          const Eigen::Vector3d& origin);

/// The plane in which a surface lies. pose, origin: as above.
RenderPlane plane_of(const GridSurface& surface, const Eigen::Isometry3d& pose,
                     const Eigen::Vector3d& origin);

/// Box around the points of a surface in space, m.
Eigen::AlignedBox3d box_of(const GridSurface& surface, const Eigen::Isometry3d& pose);

}  // namespace sherd
