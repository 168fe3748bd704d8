// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

#include "meshops/triangle_soup.h"

namespace sherd {

/// A side of a triangle of a soup, with its points in ascending order.
struct SoupSide {
    std::uint32_t low, high;
    std::size_t triangle;
    int corner;      ///< the corner where it starts
    bool is_rising;  ///< whether it starts at `low`

    auto edge() const { return std::tuple(low, high); }
    auto key() const { return std::tuple(low, high, triangle, corner); }
};

/// Calls visit(sides) for each edge, with its sides in the order of the triangles.
template <typename Visit>
void for_each_soup_edge(const TriangleSoup& soup, Visit visit) {
    std::vector<SoupSide> sides;
    sides.reserve(3 * soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto a = soup.triangles[t][corner], b = soup.triangles[t][(corner + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, corner, a < b});
        }
    }
    std::ranges::sort(sides, {}, &SoupSide::key);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && sides[end].edge() == sides[begin].edge()) ++end;
        visit(std::span<const SoupSide>(sides).subspan(begin, end - begin));
    }
}

}  // namespace sherd
