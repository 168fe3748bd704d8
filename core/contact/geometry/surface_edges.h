// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// A side of triangles, with what of the surface is nearest to it.
struct SurfaceEdge {
    std::array<Index, 2> ends{};       ///< ascending
    double area = 0;                   ///< m^2, a third of each of its triangles
    int triangles = 0;                 ///< how many have it
    std::array<Index, 2> first_two{};  ///< of these
};

/// The sides of triangles of these areas (m^2), each once, ascending by their ends.
std::vector<SurfaceEdge> surface_edges(const std::vector<std::array<Index, 3>>& triangles,
                                       const std::vector<double>& areas);

}  // namespace sherd
