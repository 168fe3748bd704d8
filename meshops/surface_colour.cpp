// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/surface_colour.h"

#include <algorithm>
#include <cmath>

namespace sherd {

Colour ColourMean::colour() const {
    Colour colour;
    std::ranges::transform(sum, colour.begin(), [](double part) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 255.0)));
    });
    return colour;
}

}  // namespace sherd
