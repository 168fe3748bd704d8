// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/geometry/surface_edges.h"

#include <algorithm>

namespace sherd {
namespace {

struct Side {
    std::array<Index, 2> ends;
    Index triangle;
};

std::vector<Side> sorted_sides(const std::vector<std::array<Index, 3>>& triangles) {
    std::vector<Side> sides;
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(triangles[f][i], triangles[f][(i + 1) % 3]);
            sides.push_back({{low, high}, static_cast<Index>(f)});
        }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.ends < b.ends; });
    return sides;
}

}  // namespace

std::vector<SurfaceEdge> surface_edges(const std::vector<std::array<Index, 3>>& triangles,
                                       const std::vector<double>& areas) {
    std::vector<SurfaceEdge> edges;
    for (const Side& side : sorted_sides(triangles)) {
        if (edges.empty() || edges.back().ends != side.ends) edges.push_back({.ends = side.ends});
        SurfaceEdge& edge = edges.back();
        edge.area += areas[side.triangle] / 3;
        if (edge.triangles < 2) edge.first_two[edge.triangles] = side.triangle;
        ++edge.triangles;
    }
    return edges;
}

}  // namespace sherd
