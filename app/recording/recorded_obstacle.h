// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"
#include "meshops/signed_distance_grid.h"

namespace sherd {

/// An obstacle that can be drawn.
struct RecordedObstacle {
    std::string name;
    GridSurface surface;  ///< in the obstacle's own frame
    bool plane = false;   ///< infinite; the surface is a square of it, which faces to the side of the sheets
    /// Whether each frame has points of its own (ObstacleShapes), where its pose is none.
    bool deforms = false;
};

/// In a frame, or between two, the points in space of each obstacle that deforms, m; empty of others.
using ObstacleShapes = std::vector<std::vector<Vector3d>>;

/// A surface with these points, or as it is if there are none.
inline GridSurface reshaped(const GridSurface& surface, const std::vector<Vector3d>& points) {
    return points.empty() ? surface : GridSurface{points, surface.triangles};
}

/// Where a frame of a recording shows its obstacles.
struct ObstaclePlaces {
    std::vector<Eigen::Isometry3d> poses;  ///< from the frame of each to space
    std::vector<std::string> points;       ///< path of the dataset with its points as they stand in space

    void visit_state(StateVisitor& visit) {
        auto& [poses, points] = *this;
        visit(poses, points);
    }
};

}  // namespace sherd
