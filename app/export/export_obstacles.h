// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/recording/recording.h"
#include "meshops/write_mesh.h"

namespace sherd {

/// An obstacle or a free body, as it is exported.
struct ExportObstacle {
    std::string name;     ///< obstacle_ram: of files and objects; no other one has it
    GridSurface surface;  ///< in its own frame
    bool plane = false;   ///< infinite; the surface is a square of it
    bool moves = false;   ///< in the chosen frames; or it deforms
    bool deforms = false;
};

/// Those of a recording, in its order. frames: that are chosen, at least one.
std::vector<ExportObstacle> export_obstacles(const Recording& recording, std::span<const std::size_t> frames);

/// A surface where a pose puts it.
TriangleSheet placed(const GridSurface& surface, const Eigen::Isometry3d& pose);

}  // namespace sherd
