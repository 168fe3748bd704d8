// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Returns the motion from an obstacle's own frame to space at a time (s): the identity if the obstacle
/// deforms.
Eigen::Isometry3d pose_of(const Obstacle& obstacle, double time);

/// Obstacles of a scene as a recording shows them, free bodies last. A plane is shown as a square near
/// everything else; half its side is the diagonal of the box around that at the start.
class ObstacleTrack {
  public:
    /// The simulation must be that of the scene, before its first step.
    ObstacleTrack(const Scene& scene, const Simulation& simulation);

    const std::vector<RecordedObstacle>& obstacles() const { return recorded; }
    /// Returns the motions from each obstacle's own frame to space at the simulation's time.
    std::vector<Eigen::Isometry3d> poses(const Simulation& simulation) const;
    ObstacleShapes shapes(const Simulation& simulation) const;

  private:
    std::vector<RecordedObstacle> recorded;
    std::vector<std::size_t> numbers;  ///< index in the simulation of each obstacle that is not a free body
};

}  // namespace sherd
