// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>

#include "app/playback/moment.h"
#include "app/recording/recording.h"
#include "fracture/snapshot.h"

namespace sherd {

/// The sheets of a recording at moments, which are best asked for in their order: the frames around the last
/// one are kept.
class Playback {
  public:
    /// read: the frame of a number.
    explicit Playback(std::function<Snapshot(std::size_t)> read);

    /// As recorded, or interpolated(). Throws what reading throws.
    Snapshot at(const Moment& moment);

  private:
    const Snapshot& frame(std::size_t number);

    std::function<Snapshot(std::size_t)> read;
    std::map<std::size_t, Snapshot> kept;  ///< by number
};

/// m, of the points of an obstacle's surface: what it turns about between frames.
Vector3d middle(const GridSurface& surface);

/// The obstacles of a recording at moments.
class ObstaclePlayback {
  public:
    /// Refers to the recording.
    explicit ObstaclePlayback(const Recording& recording);

    /// From the frame of each to space, as recorded or interpolated() about its middle.
    std::vector<Eigen::Isometry3d> at(const Moment& moment) const;
    /// As recorded, or with each point on the straight way between two frames.
    ObstacleShapes shapes(const Moment& moment) const;

  private:
    const Recording& recording;
    std::vector<Vector3d> middles;  ///< m, of each, in its own frame
};

}  // namespace sherd
