// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repair/repeated_polygons.h"

#include <algorithm>
#include <numeric>

namespace sherd {
namespace {

using PolygonCorners = std::vector<std::size_t>;
using PolygonSide = std::pair<std::size_t, std::size_t>;

/// Returns the corners of a polygon in an order that is independent of its first corner and its orientation.
PolygonCorners ordered_corners(const PolygonCorners& corners) {
    PolygonCorners best;
    PolygonCorners turned(corners.rbegin(), corners.rend());
    for (PolygonCorners way : {corners, turned}) {
        std::rotate(way.begin(), std::ranges::min_element(way), way.end());
        if (best.empty() || way < best) best = way;
    }
    return best;
}

void append_sides(const PolygonCorners& corners, std::vector<PolygonSide>& sides) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
}

/// Returns the sides that occur an odd number of times; a side between two parts of a polygon occurs twice
/// and cancels.
std::vector<PolygonSide> outline(std::vector<PolygonSide> sides) {
    std::ranges::sort(sides);
    std::vector<PolygonSide> result;
    for (const PolygonSide& side : sides) {
        if (!result.empty() && result.back() == side)
            result.pop_back();
        else
            result.push_back(side);
    }
    return result;
}

/// The polygons that use each point.
class PolygonsAt {
  public:
    explicit PolygonsAt(const PolygonSoup& soup) : soup(soup), first(soup.points.size() + 1, 0) {
        for (const auto& corners : soup.polygons)
            for (const std::size_t point : corners) ++first[point + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        polygons.resize(first.back());
        std::vector<std::size_t> next = first;
        for (std::size_t i = 0; i < soup.polygons.size(); ++i)
            for (const std::size_t point : soup.polygons[i]) polygons[next[point]++] = i;
    }

    /// Returns, ascending, the polygons that have fewer corners than `polygon`, all of which are corners of
    /// `polygon`, too.
    std::vector<std::size_t> parts_of(std::size_t polygon) const {
        const PolygonCorners& corners = soup.polygons[polygon];
        const auto is_corner = [&](std::size_t point) {
            return std::ranges::find(corners, point) != corners.end();
        };
        std::vector<std::size_t> parts;
        for (const std::size_t point : corners)
            for (std::size_t i = first[point]; i < first[point + 1]; ++i) {
                const PolygonCorners& other = soup.polygons[polygons[i]];
                if (other.size() < corners.size() && std::ranges::all_of(other, is_corner))
                    parts.push_back(polygons[i]);
            }
        std::ranges::sort(parts);
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        return parts;
    }

  private:
    const PolygonSoup& soup;
    /// The polygons at point p are entries first[p] to first[p + 1] - 1 of `polygons`.
    std::vector<std::size_t> first, polygons;
};

void add_repeated_wholes(const PolygonSoup& soup, std::vector<RepeatedPolygon>& repeated) {
    std::vector<std::pair<PolygonCorners, std::size_t>> known;
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
        if (soup.polygons[i].size() > 3) known.emplace_back(ordered_corners(soup.polygons[i]), i);
    std::ranges::sort(known);
    for (std::size_t i = 1, whole = 0; i < known.size(); ++i) {
        if (known[i].first == known[whole].first)
            repeated.push_back({known[i].second, known[whole].second});
        else
            whole = i;
    }
}

/// Whether the parts together, without repetitions, have the outline of the polygon.
bool fill(const PolygonSoup& soup, const std::vector<std::size_t>& parts, std::size_t polygon) {
    std::vector<PolygonCorners> different;
    for (const std::size_t part : parts) different.push_back(ordered_corners(soup.polygons[part]));
    std::ranges::sort(different);
    different.erase(std::unique(different.begin(), different.end()), different.end());
    std::vector<PolygonSide> sides, whole;
    for (const PolygonCorners& corners : different) append_sides(corners, sides);
    append_sides(soup.polygons[polygon], whole);
    return outline(sides) == outline(whole);
}

void add_repeated_parts(const PolygonSoup& soup, std::vector<RepeatedPolygon>& repeated) {
    std::vector<bool> is_repeated(soup.polygons.size(), false);
    for (const RepeatedPolygon& known : repeated) is_repeated[known.polygon] = true;
    const PolygonsAt polygons_at(soup);
    for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
        if (soup.polygons[i].size() <= 3 || is_repeated[i]) continue;
        std::vector<std::size_t> parts = polygons_at.parts_of(i);
        std::erase_if(parts, [&](std::size_t part) { return is_repeated[part]; });
        if (parts.empty() || !fill(soup, parts, i)) continue;
        if (parts[0] < i) {
            repeated.push_back({i, parts[0]});
            is_repeated[i] = true;
            continue;
        }
        for (const std::size_t part : parts) {
            repeated.push_back({part, i});
            is_repeated[part] = true;
        }
    }
}

}  // namespace

std::vector<RepeatedPolygon> repeated_polygons(const PolygonSoup& soup) {
    std::vector<RepeatedPolygon> repeated;
    const auto is_triangle = [](const PolygonCorners& corners) { return corners.size() <= 3; };
    if (std::ranges::all_of(soup.polygons, is_triangle)) return repeated;
    add_repeated_wholes(soup, repeated);
    add_repeated_parts(soup, repeated);
    std::ranges::sort(repeated, {}, &RepeatedPolygon::polygon);
    return repeated;
}

}  // namespace sherd
