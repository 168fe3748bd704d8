// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "app/render/trace/render_scene.h"
#include "meshops/level_set/signed_distance_grid.h"

namespace sherd {

/// Colour of obstacles, 0xRRGGBB (sRGB).
inline constexpr std::uint32_t obstacle_grey = 0x8c8f93;

/// Returns the mesh of an obstacle: grey, with sharp edges where creased() splits its surface. pose: from the
/// obstacle's own frame of reference to space; origin: m, is subtracted from all positions.
RenderMesh obstacle_solid(const GridSurface& surface, const Eigen::Isometry3d& pose,
                          const Eigen::Vector3d& origin);

/// Returns the plane in which a flat surface lies. pose, origin: as for obstacle_solid().
RenderPlane plane_of(const GridSurface& surface, const Eigen::Isometry3d& pose,
                     const Eigen::Vector3d& origin);

/// Returns the box (m) in space around the points of a surface. pose: as for obstacle_solid().
Eigen::AlignedBox3d box_of(const GridSurface& surface, const Eigen::Isometry3d& pose);

}  // namespace sherd
