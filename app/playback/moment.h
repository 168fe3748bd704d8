// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sherd {

/// A moment of a run: that of a frame of its recording (share 0, later the same as earlier), or between two.
struct Moment {
    std::size_t earlier = 0, later = 0;  ///< numbers of frames
    double share = 0;                    ///< of the way from the earlier frame to the later one, below 1
    double time = 0;                     ///< s
};

/// Those of the frames themselves. times: s, of each of the frames.
std::vector<Moment> recorded_moments(std::span<const std::size_t> frames, std::span<const double> times);

/// `step` seconds apart, from the first frame on; the last frame ends them, even where that step is shorter.
/// Near a frame's time (a millionth of the way to the next) it is that frame. One alone when all frames have
/// one time. times: s, of each of the frames, ascending. Throws Error (input) when there would be more than
/// 100,000.
std::vector<Moment> even_moments(std::span<const std::size_t> frames, std::span<const double> times,
                                 double step);

}  // namespace sherd
