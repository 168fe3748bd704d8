// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "app/recording/hdf5.h"
#include "app/recording/recorded_obstacle.h"

namespace sherd::recording_format {

/// Writes the surfaces of obstacles into the head of a recording.
void write_obstacles(hid_t file, std::span<const RecordedObstacle> obstacles);

/// Before the first frame each stands in its own frame.
ObstaclePlaces first_places(std::span<const RecordedObstacle> obstacles);

/// The places in a frame. One that has not moved since `before` has its points where it had them; else, and
/// if it deforms, they are a dataset of this frame. Throws Error (run) when there are not as many poses as
/// obstacles, or shapes are missing.
ObstaclePlaces next_places(const ObstaclePlaces& before, std::size_t frame,
                           std::span<const RecordedObstacle> obstacles,
                           std::span<const Eigen::Isometry3d> poses, const ObstacleShapes& shapes);

/// Writes the poses of a frame, and the points of what has moved or deforms: next_places().
void write_places(hid_t file, std::size_t frame, std::span<const RecordedObstacle> obstacles,
                  const ObstaclePlaces& places, const ObstacleShapes& shapes);

}  // namespace sherd::recording_format
