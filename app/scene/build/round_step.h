// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace sherd {

/// Rounds a step (s) down to one significant digit, to be written into a scene.
inline double round_step(double longest) {
    const double digit = std::pow(10.0, std::floor(std::log10(longest)));
    return std::floor(longest / digit + 1e-9) * digit;
}

}  // namespace sherd
