// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sherd {

/// Processor time of this program so far, s, of all of its threads together.
double processor_seconds();

// The least of some rounds: of many short ones some are not disturbed by what else runs.

/// Processor time, s.
double least_seconds(int rounds, const std::function<void()>& work);
/// The same of three rounds.
inline double least_seconds(const std::function<void()>& work) {
    return least_seconds(3, work);
}
/// Wall time, s.
double least_wall_seconds(int rounds, const std::function<void()>& work);

}  // namespace sherd
