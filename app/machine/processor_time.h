// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sherd {

/// Returns the processor time, s, that all threads of this program together have used so far.
double processor_seconds();

// The functions below call `work` in several rounds, and return the time of the fastest round: among many
// short rounds some are not disturbed by other programs.

/// Returns the processor time of the fastest of `rounds` rounds, s.
double least_seconds(int rounds, const std::function<void()>& work);
/// Returns the processor time of the fastest of three rounds, s.
inline double least_seconds(const std::function<void()>& work) {
    return least_seconds(3, work);
}
/// Returns the wall time of the fastest of `rounds` rounds, s.
double least_wall_seconds(int rounds, const std::function<void()>& work);

}  // namespace sherd
