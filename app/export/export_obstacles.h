// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/recording/recording.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// An obstacle or a free body to be exported.
struct ExportObstacle {
    std::string name;     ///< unique name for files and objects, as obstacle_ram
    GridSurface surface;  ///< in the obstacle's own coordinates
    bool plane = false;   ///< whether it is an infinite plane; the surface is then a square of the plane
    bool moves = false;   ///< whether it moves or deforms between the chosen frames
    bool deforms = false;
};

/// Returns the obstacles of a recording, in its order. frames: numbers of the chosen frames, at least one.
std::vector<ExportObstacle> export_obstacles(const Recording& recording, std::span<const std::size_t> frames);

/// Returns a surface moved by a pose.
TriangleSheet placed(const GridSurface& surface, const Eigen::Isometry3d& pose);

}  // namespace sherd
