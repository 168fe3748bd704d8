// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sherd {

/// State of an edge (paper, appendix B). It only increases.
enum class EdgeState : std::uint8_t {
    interior = 0,            ///< has a hinge
    fractured_interior = 1,  ///< failed but closed: its two faces share both end points
    boundary = 2             ///< open, or on the boundary from the start
};

}  // namespace sherd
