// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace sherd {

/// Spacing of doubles, in edge lengths, above which positions are too coarse: thin glass breaks at a strain
/// of a hundred times this number, and corrections of Newton's method have to get below it.
constexpr double coarsest_spacing = 1e-7;

/// Returns the spacing (m) of doubles near a coordinate (m).
constexpr double position_spacing(double coordinate) {
    return std::numeric_limits<double>::epsilon() * coordinate;
}

}  // namespace sherd
