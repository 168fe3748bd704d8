// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/seams.h"

#include <algorithm>

#include "meshops/soup_edges.h"

namespace sherd {

std::vector<std::array<std::uint32_t, 2>> seam_edges(const TriangleSoup& soup) {
    struct Placed {
        std::array<Point, 2> ends;
        std::array<std::uint32_t, 2> points;
    };
    std::vector<Placed> borders;
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() != 1) return;
        const auto a = sides[0].low, b = sides[0].high;
        const bool rising = soup.points[a] < soup.points[b];
        borders.push_back({{soup.points[rising ? a : b], soup.points[rising ? b : a]}, {a, b}});
    });
    std::ranges::sort(borders, [](const Placed& a, const Placed& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.points < b.points;
    });
    std::vector<std::array<std::uint32_t, 2>> seams;
    for (std::size_t i = 0; i < borders.size(); ++i) {
        const bool as_before = i > 0 && borders[i].ends == borders[i - 1].ends;
        const bool as_next = i + 1 < borders.size() && borders[i].ends == borders[i + 1].ends;
        if (as_before || as_next) seams.push_back(borders[i].points);
    }
    std::ranges::sort(seams);
    return seams;
}

}  // namespace sherd
