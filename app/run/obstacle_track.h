// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Returns the pose of an obstacle at a time (s), from the obstacle's own frame to space: the identity if the
/// obstacle deforms.
Eigen::Isometry3d pose_of(const Obstacle& obstacle, double time);

/// Obstacles of a scene as a recording shows them, free bodies last. A plane is shown as a square around its
/// point nearest to the centre of the box that contains all sheets, free bodies and other obstacles at the
/// start. Half the square's side is the diagonal of this box.
class ObstacleTrack {
  public:
    /// The simulation must be that of the scene, before its first step.
    ObstacleTrack(const Scene& scene, const Simulation& simulation);

    const std::vector<RecordedObstacle>& obstacles() const { return recorded; }
    /// Returns the poses of obstacles(), from each obstacle's own frame to space, at the simulation's time.
    std::vector<Eigen::Isometry3d> poses(const Simulation& simulation) const;
    ObstacleShapes shapes(const Simulation& simulation) const;

  private:
    std::vector<RecordedObstacle> recorded;
    std::vector<std::size_t> numbers;  ///< index in Simulation::obstacles() of each recorded obstacle that is
                                       ///< no free body
};

}  // namespace sherd
