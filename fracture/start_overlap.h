// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/vector.h"

namespace sherd {

/// Elements nearer than this share of half the sum of their thicknesses touch: a barrier over so small a
/// distance would stop all motion.
inline constexpr double touching = 0.01;

/// Two faces that intersect or are too close for a first step.
struct StartOverlap {
    std::array<Index, 2> faces{};  ///< ascending
    /// Whether they intersect beyond shared vertices and edges, or touch (see `touching`).
    bool crossing = false;
    double distance = 0;                 ///< m, between their middle surfaces; 0 if they cross
    double needed = 0;                   ///< m, their activation distance; 0 if they cross
    Vector3d normal = Vector3d::Zero();  ///< unit vector from the first to the second; 0 if they cross
};

}  // namespace sherd
