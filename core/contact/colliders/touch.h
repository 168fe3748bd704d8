// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <set>

#include "core/vector.h"

namespace sherd {

/// Vertices, obstacles and bodies in contact.
struct Touch {
    std::set<Index> vertices;  ///< vertices of sheets that touch a collider, or that belong to an element
                               ///< that touches a collider's surface
    double deepest = 0;        ///< m, the largest overlap of a vertex
    /// Numbers of obstacles and bodies that a sheet or a body touches.
    std::set<std::size_t> obstacles, bodies;

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
    /// Includes the contacts of an obstacle. number: number of the obstacle; own: contacts of vertices with
    /// its shape; by_surface: whether elements touch its surface.
    void include_obstacle(std::size_t number, const Touch& own, bool by_surface) {
        if (!own.vertices.empty() || by_surface) obstacles.insert(number);
        include(own);
    }
};

}  // namespace sherd
