// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <map>

#include "app/playback/playback_time.h"
#include "app/recording/recording.h"
#include "fracture/snapshot.h"

namespace sherd {

/// Sheets of a recording at moments, which are read fastest in ascending order: the frames around the last
/// one are kept.
class Playback {
  public:
    /// read: returns the frame of a number.
    explicit Playback(std::function<Snapshot(std::size_t)> read);

    /// Returns a frame as recorded, or interpolated(). Throws what `read` throws.
    Snapshot at(const PlaybackTime& moment);

  private:
    const Snapshot& frame(std::size_t number);

    std::function<Snapshot(std::size_t)> read;
    std::map<std::size_t, Snapshot> kept;  ///< frames by number
};

/// Mean of the points of an obstacle's surface, m, about which it turns between frames.
Vector3d middle(const GridSurface& surface);

/// Obstacles of a recording at moments.
class ObstaclePlayback {
  public:
    /// The recording must outlive this object.
    explicit ObstaclePlayback(const Recording& recording);

    /// Returns the motions from each obstacle's own frame to space, as recorded, or interpolated() about its
    /// middle.
    std::vector<Eigen::Isometry3d> at(const PlaybackTime& moment) const;
    /// Returns the points of deforming obstacles, as recorded, or linear between two frames.
    ObstacleShapes shapes(const PlaybackTime& moment) const;

  private:
    const Recording& recording;
    std::vector<Vector3d> middles;  ///< m, middle() of each obstacle, in its own frame
};

}  // namespace sherd
