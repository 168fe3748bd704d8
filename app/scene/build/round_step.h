// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace sherd {

/// A step (s) to write into a scene: one digit, not above this one.
inline double round_step(double longest) {
    const double digit = std::pow(10.0, std::floor(std::log10(longest)));
    return std::floor(longest / digit + 1e-9) * digit;
}

}  // namespace sherd
