// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <set>

#include "core/vector.h"

namespace sherd {

/// What touches obstacles and bodies.
struct Touch {
    std::set<Index> vertices;                 ///< of sheets, by themselves or with a triangle or an edge
    double deepest = 0;                       ///< m, depth of the deepest one's skin
    std::set<std::size_t> obstacles, bodies;  ///< that a sheet or a body touches

    void include(Index vertex, double depth) {
        if (depth <= 0) return;
        vertices.insert(vertex);
        deepest = std::max(deepest, depth);
    }
    void include(const Touch& other) {
        vertices.insert(other.vertices.begin(), other.vertices.end());
        deepest = std::max(deepest, other.deepest);
        obstacles.insert(other.obstacles.begin(), other.obstacles.end());
        bodies.insert(other.bodies.begin(), other.bodies.end());
    }
};

}  // namespace sherd
