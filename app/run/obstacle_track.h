// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Returns the motion from an obstacle's own frame to space at a time (s). The frame of one that deforms is
/// space.
Eigen::Isometry3d pose_of(const Obstacle& obstacle, double time);

/// Holds what a recording shows of a scene's obstacles, the free ones last. Of a plane it shows a square
/// around where everything else starts: its half side is as long as the diagonal of the box around that.
class ObstacleTrack {
  public:
    /// The simulation has to be that of the scene, and not to have made a step yet.
    ObstacleTrack(const Scene& scene, const Simulation& simulation);

    const std::vector<RecordedObstacle>& obstacles() const { return recorded; }
    /// Returns the motions from the frame of each to space, as the simulation stands.
    std::vector<Eigen::Isometry3d> poses(const Simulation& simulation) const;
    ObstacleShapes shapes(const Simulation& simulation) const;

  private:
    std::vector<RecordedObstacle> recorded;
    std::vector<std::size_t> numbers;  ///< in the simulation, of those that are not free
};

}  // namespace sherd
