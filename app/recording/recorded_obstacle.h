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
    bool plane = false;   ///< infinite plane; the surface is a square of it that faces the sheets
    /// Whether each frame has its points (ObstacleShapes); its pose is then the identity.
    bool deforms = false;
};

/// Points in space of each obstacle that deforms, m, in a frame or between two; empty for other obstacles.
using ObstacleShapes = std::vector<std::vector<Vector3d>>;

/// Returns the surface with other points, or unchanged if `points` is empty.
inline GridSurface reshaped(const GridSurface& surface, const std::vector<Vector3d>& points) {
    return points.empty() ? surface : GridSurface{points, surface.triangles};
}

/// Places of the obstacles in a frame of a recording.
struct ObstaclePlaces {
    std::vector<Eigen::Isometry3d> poses;  ///< from each obstacle's own frame to space
    std::vector<std::string> points;       ///< path of the dataset with each obstacle's points in space

    void visit_state(StateVisitor& visit) {
        auto& [poses, points] = *this;
        visit(poses, points);
    }
};

}  // namespace sherd
