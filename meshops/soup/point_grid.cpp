// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/soup/point_grid.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr std::int64_t most_rows = 1 << 20;  // along an axis; three row numbers fit into a key

Point moved(const Point& point, double by) {
    return {point.x() + by, point.y() + by, point.z() + by};
}

}  // namespace

PointGrid::PointGrid(const std::vector<Point>& points, std::vector<std::uint32_t> chosen_points, double cell)
    : points(points), chosen(std::move(chosen_points)), cell(cell) {
    if (chosen.empty()) return;
    std::array<double, 3> low{}, high{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto coordinate = [&](std::uint32_t i) { return points[i][axis]; };
        const auto [least, most] = std::ranges::minmax(chosen, {}, coordinate);
        low[axis] = coordinate(least), high[axis] = coordinate(most);
        this->cell = std::max(this->cell, (high[axis] - low[axis]) / (most_rows - 1));
    }
    origin = Point(low[0], low[1], low[2]);
    if (!(this->cell > 0)) this->cell = 1;
    for (const std::uint32_t i : chosen)
        for_each_cell(points[i], points[i], [&](std::uint64_t key) { found[key].push_back(i); });
}

std::int64_t PointGrid::row(double coordinate, int axis) const {
    const double rows = std::floor((coordinate - origin[axis]) / cell);
    return rows > 0 ? static_cast<std::int64_t>(std::min(rows, static_cast<double>(most_rows - 1))) : 0;
}

template <class Visit>
void PointGrid::for_each_cell(const Point& low, const Point& high, Visit visit) const {
    for (std::int64_t x = row(low.x(), 0); x <= row(high.x(), 0); ++x)
        for (std::int64_t y = row(low.y(), 1); y <= row(high.y(), 1); ++y)
            for (std::int64_t z = row(low.z(), 2); z <= row(high.z(), 2); ++z)
                visit(static_cast<std::uint64_t>((x * most_rows + y) * most_rows + z));
}

std::vector<std::uint32_t> PointGrid::candidates(const Point& a, const Point& b, double distance) const {
    const auto whole = b - a;
    const double pieces = std::max(std::ceil(std::sqrt(whole.squared_length()) / cell), 1.0);
    const double cells = pieces * std::pow(2 + 2 * distance / cell, 3);
    // If a segment is much longer than a cell, all points are fewer than the cells around the segment.
    if (!(cells <= static_cast<double>(chosen.size()) + 64)) return chosen;
    std::vector<std::uint32_t> result;
    for (double piece = 0; piece < pieces; ++piece) {
        const Point from = a + whole * (piece / pieces), to = a + whole * ((piece + 1) / pieces);
        const Point low(std::min(from.x(), to.x()), std::min(from.y(), to.y()), std::min(from.z(), to.z()));
        const Point high(std::max(from.x(), to.x()), std::max(from.y(), to.y()), std::max(from.z(), to.z()));
        for_each_cell(moved(low, -distance), moved(high, distance), [&](std::uint64_t key) {
            const auto here = found.find(key);
            if (here != found.end()) result.insert(result.end(), here->second.begin(), here->second.end());
        });
    }
    return result;
}

std::vector<std::uint32_t> PointGrid::near_segment(const Point& a, const Point& b, double distance) const {
    std::vector<std::uint32_t> near = candidates(a, b, distance);
    std::erase_if(near,
                  [&](std::uint32_t i) { return place_on_segment(points[i], a, b).distance > distance; });
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    return near;
}

PlaceOnSegment place_on_segment(const Point& point, const Point& a, const Point& b) {
    const auto along = b - a;
    const double squared = along.squared_length();
    const double share = squared > 0 ? std::clamp((point - a) * along / squared, 0.0, 1.0) : 0.0;
    return {share, std::sqrt(CGAL::squared_distance(point, a + along * share))};
}

}  // namespace sherd
