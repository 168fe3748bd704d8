// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// An edge of a triangle surface, with the area of the surface that is nearest to it.
struct SurfaceEdge {
    std::array<Index, 2> ends{};       ///< vertex numbers, ascending
    double area = 0;                   ///< m^2, a third of the total area of the adjacent triangles
    int triangles = 0;                 ///< number of adjacent triangles
    std::array<Index, 2> first_two{};  ///< numbers of the first two adjacent triangles
};

/// Returns each edge of the triangles once, in ascending order of the edges' ends. areas: m^2, of the
/// triangles.
std::vector<SurfaceEdge> surface_edges(const std::vector<std::array<Index, 3>>& triangles,
                                       const std::vector<double>& areas);

}  // namespace sherd
