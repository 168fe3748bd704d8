// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace sherd {

// Okabe and Ito's palette.
inline constexpr const char *blue = "#0072b2", *vermillion = "#d55e00", *green = "#009e73",
                            *purple = "#cc79a7", *yellow = "#f0e442", *orange = "#e69f00", *black = "#000000",
                            *sky = "#56b4e9";

/// Colours of several lines, in this order.
inline constexpr std::array series_colours{blue, vermillion, green, purple, orange, black};

}  // namespace sherd
