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

/// A time of a run: that of a frame of its recording (share 0, later equal to earlier), or between two
/// frames.
struct PlaybackTime {
    std::size_t earlier = 0, later = 0;  ///< numbers of frames
    double share = 0;  ///< fraction of the time from the earlier to the later frame, below 1
    double time = 0;   ///< s
};

/// Returns the moments of the frames. times: s, of each of the frames.
std::vector<PlaybackTime> recorded_times(std::span<const std::size_t> frames, std::span<const double> times);

/// Returns moments that are `step` seconds apart, from the first frame on; the last frame ends them, even if
/// that step is shorter. A moment near a frame's time (a millionth of the time to the next) is that frame.
/// Returns a single moment if all frames have the same time. times: s, of each of the frames, ascending.
/// Throws Error (input) if there would be more than 100,000.
std::vector<PlaybackTime> even_times(std::span<const std::size_t> frames, std::span<const double> times,
                                     double step);

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
