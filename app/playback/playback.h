// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "app/recording/recording.h"
#include "fracture/record/snapshot.h"

namespace sherd {

/// A moment of a run: the time of a frame of its recording, with share 0 and `later` equal to `earlier`, or a
/// time between two frames.
struct PlaybackTime {
    std::size_t earlier = 0, later = 0;  ///< numbers of frames
    double share = 0;  ///< fraction of the time between both frames that has passed, below 1
    double time = 0;   ///< s, time of the moment
};

/// Returns the moments at which the given frames were recorded. times: s, time of each of the frames.
std::vector<PlaybackTime> recorded_times(std::span<const std::size_t> frames, std::span<const double> times);

/// Returns moments that are `step` seconds of simulated time apart, from the first of the given frames to the
/// last one; the last step may be shorter. If a moment differs from a frame's time by less than a millionth
/// of the time to the next frame, it becomes that frame. Returns a single moment if all frames have the same
/// time. times: s, time of each of the frames, ascending. Throws Error (input) if there would be more than
/// 100,000 moments.
std::vector<PlaybackTime> even_times(std::span<const std::size_t> frames, std::span<const double> times,
                                     double step);

/// Sheets of a recording at given moments. The frames around the last moment are kept in memory, so that
/// moments in ascending order are read fastest.
class Playback {
  public:
    /// read(number): returns the frame with this number.
    explicit Playback(std::function<Snapshot(std::size_t)> read);

    /// Returns the sheets at a moment: a frame as recorded, or two frames interpolated(). Throws what `read`
    /// and interpolated() throw.
    Snapshot at(const PlaybackTime& moment);

  private:
    const Snapshot& frame(std::size_t number);

    std::function<Snapshot(std::size_t)> read;
    std::map<std::size_t, Snapshot> kept;  ///< frames by number
};

/// Returns the mean of the points of an obstacle's surface, m, about which the obstacle turns between frames.
Vector3d middle(const GridSurface& surface);

/// Obstacles of a recording at given moments.
class ObstaclePlayback {
  public:
    /// The recording must outlive this object.
    explicit ObstaclePlayback(const Recording& recording);

    /// Returns the pose of each obstacle, from its own frame to space: as recorded, or interpolated() about
    /// the obstacle's middle.
    std::vector<Eigen::Isometry3d> at(const PlaybackTime& moment) const;
    /// Returns the points of obstacles that deform: as recorded, or interpolated linearly between two frames.
    ObstacleShapes shapes(const PlaybackTime& moment) const;

  private:
    const Recording& recording;
    std::vector<Vector3d> middles;  ///< m, middle() of each obstacle, in its own frame
};

}  // namespace sherd
