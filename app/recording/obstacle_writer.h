// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/recording/hdf5.h"
#include "app/recording/recording.h"

namespace sherd::recording_format {

/// Writes the surfaces of obstacles into the header of a recording.
void write_obstacles(hid_t file, std::span<const RecordedObstacle> obstacles);

/// Returns the places before the first frame: identity poses, and the points in the header.
ObstaclePlaces first_places(std::span<const RecordedObstacle> obstacles);

/// Returns the places in the frame number `frame`; `before` are the places in the previous frame. An obstacle
/// that has not moved since then keeps its dataset of points; an obstacle that has moved, or deforms, gets a
/// dataset in this frame. Throws Error (run) if the numbers of poses and obstacles differ, or if points of a
/// deforming obstacle are missing.
ObstaclePlaces next_places(const ObstaclePlaces& before, std::size_t frame,
                           std::span<const RecordedObstacle> obstacles,
                           std::span<const Eigen::Isometry3d> poses, const ObstacleShapes& shapes);

/// Writes the poses of a frame, and the points of obstacles that have moved or deform (next_places()).
void write_places(hid_t file, std::size_t frame, std::span<const RecordedObstacle> obstacles,
                  const ObstaclePlaces& places, const ObstacleShapes& shapes);

}  // namespace sherd::recording_format
