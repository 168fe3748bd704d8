// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// An edge of a triangle surface, with the area of the surface that is nearest to it.
struct SurfaceEdge {
    std::array<Index, 2> ends{};       ///< ascending
    double area = 0;                   ///< m^2, a third of the area of each adjacent triangle
    int triangles = 0;                 ///< number of adjacent triangles
    std::array<Index, 2> first_two{};  ///< numbers of the first two adjacent triangles
};

/// The edges of triangles with the given areas (m^2), each once, in ascending order of their ends.
std::vector<SurfaceEdge> surface_edges(const std::vector<std::array<Index, 3>>& triangles,
                                       const std::vector<double>& areas);

}  // namespace sherd
