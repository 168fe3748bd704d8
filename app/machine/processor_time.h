// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sherd {

/// Processor time of this program so far, s, of all of its threads together.
double processor_seconds();

// Smallest time of several rounds: of many short rounds some are not disturbed by other programs.

/// Processor time, s.
double least_seconds(int rounds, const std::function<void()>& work);
/// Processor time of three rounds, s.
inline double least_seconds(const std::function<void()>& work) {
    return least_seconds(3, work);
}
/// Wall time, s.
double least_wall_seconds(int rounds, const std::function<void()>& work);

}  // namespace sherd
