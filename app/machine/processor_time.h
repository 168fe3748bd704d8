// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sherd {

/// Processor time of this program so far, s, of all of its threads together.
double processor_seconds();

constexpr int rounds_of_least_seconds = 3;

/// The least processor time of some rounds, s.
double least_seconds(const std::function<void()>& work);

/// The least wall time of so many rounds, s: of short ones some are not disturbed by what else runs.
double least_wall_seconds(int rounds, const std::function<void()>& work);

}  // namespace sherd
