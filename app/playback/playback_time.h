// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

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

}  // namespace sherd
