// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/soup/polygon_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "meshops/error.h"
#include "meshops/number_text.h"
#include "meshops/soup/point_grid.h"

namespace sherd {
namespace {

std::string place(const std::filesystem::path& file, const std::vector<std::size_t>& lines, const char* kind,
                  std::size_t number) {
    const std::string line = lines.empty() ? "" : ":" + std::to_string(lines[number]);
    return file.string() + line + ": " + kind + " " + std::to_string(number);
}

bool is_finite(const Point& point) {
    return std::isfinite(point.x()) && std::isfinite(point.y()) && std::isfinite(point.z());
}

std::vector<std::size_t> numbers_from_0(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return numbers;
}

std::vector<std::size_t> chosen_points(const std::vector<bool>& is_chosen) {
    std::vector<std::size_t> points = numbers_from_0(is_chosen.size());
    std::erase_if(points, [&](std::size_t i) { return !is_chosen[i]; });
    return points;
}

void replace_corners(PolygonSoup& soup, const std::vector<std::size_t>& by) {
    for (auto& polygon : soup.polygons)
        for (auto& corner : polygon) corner = by[corner];
}

struct PolygonBorder {
    std::vector<std::uint32_t> points;  ///< ascending
    double mean_side = 0;
};

/// Returns the points, and the mean length, of the sides that only one polygon has.
PolygonBorder border_of(const PolygonSoup& soup) {
    std::vector<std::array<std::size_t, 2>> sides;
    for (const auto& polygon : soup.polygons)
        for (std::size_t i = 0; polygon.size() >= 3 && i < polygon.size(); ++i) {
            const auto [low, high] = std::minmax(polygon[i], polygon[(i + 1) % polygon.size()]);
            if (low != high) sides.push_back({low, high});
        }
    std::ranges::sort(sides);
    PolygonBorder border;
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if ((i > 0 && sides[i] == sides[i - 1]) || (i + 1 < sides.size() && sides[i] == sides[i + 1]))
            continue;
        for (const std::size_t end : sides[i]) border.points.push_back(static_cast<std::uint32_t>(end));
        sum += std::sqrt(CGAL::squared_distance(soup.points[sides[i][0]], soup.points[sides[i][1]]));
        ++count;
    }
    std::ranges::sort(border.points);
    border.points.erase(std::unique(border.points.begin(), border.points.end()), border.points.end());
    if (count > 0) border.mean_side = sum / count;
    return border;
}

}  // namespace

std::string place_of_point(const PolygonSoup& soup, std::size_t point) {
    return place(soup.file, soup.point_line, "vertex", point);
}

std::string place_of_polygon(const PolygonSoup& soup, std::size_t polygon) {
    return place(soup.file, soup.polygon_line, "face", polygon);
}

void check_polygon_soup(const PolygonSoup& soup) {
    if (soup.polygons.empty()) {
        throw Error(soup.file.string() + ": the mesh has no faces; a sheet needs at least one triangle");
    }
    for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
        for (const std::size_t corner : soup.polygons[i]) {
            if (corner >= soup.points.size()) {
                // Files have signed numbers, so that the message shows -1 as -1.
                throw Error(place_of_polygon(soup, i) + ": index out of range: there is no vertex " +
                            std::to_string(static_cast<std::ptrdiff_t>(corner)) + ", the file has " +
                            std::to_string(soup.points.size()) + " (numbered from 0)");
            }
        }
    }
    const std::vector<bool> is_used = used_points(soup);
    for (std::size_t i = 0; i < soup.points.size(); ++i)
        if (is_used[i] && !is_finite(soup.points[i]))
            throw Error(place_of_point(soup, i) + ": a coordinate is NaN or infinite");
}

std::vector<bool> used_points(const PolygonSoup& soup) {
    std::vector<bool> is_used(soup.points.size(), false);
    for (const auto& polygon : soup.polygons)
        if (polygon.size() >= 3)
            for (const std::size_t corner : polygon) is_used[corner] = true;
    return is_used;
}

std::vector<std::size_t> polygons_of_few_corners(const PolygonSoup& soup) {
    std::vector<std::size_t> few;
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
        if (soup.polygons[i].size() < 3) few.push_back(i);
    return few;
}

std::size_t join_duplicate_points(PolygonSoup& soup) {
    // Unused points may be NaN, which has no order.
    std::vector<std::size_t> order = chosen_points(used_points(soup));
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return soup.points[a] != soup.points[b] ? soup.points[a] < soup.points[b] : a < b;
    });
    std::vector<std::size_t> first = numbers_from_0(soup.points.size());
    std::size_t joined = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        const bool repeats = soup.points[order[i]] == soup.points[order[i - 1]];
        if (repeats) first[order[i]] = first[order[i - 1]];
        joined += repeats;
    }
    replace_corners(soup, first);
    return joined;
}

std::size_t join_near_points(PolygonSoup& soup, double distance) {
    const auto [ends, mean_side] = border_of(soup);
    if (ends.empty()) return 0;
    if (!(2 * distance < mean_side))
        throw Error(soup.file.string() + ": vertices that are " + number_text(distance) +
                    " apart in the file would be joined, but border edges are " + number_text(mean_side) +
                    " long on average: give a smaller distance");
    const PointGrid grid(soup.points, ends, mean_side);
    std::vector<std::size_t> first = numbers_from_0(soup.points.size());
    std::size_t joined = 0;
    for (const std::uint32_t point : ends) {
        double least = std::numeric_limits<double>::infinity();
        for (const std::uint32_t other : grid.near_point(soup.points[point], distance)) {
            const double squared = CGAL::squared_distance(soup.points[point], soup.points[other]);
            if (other >= point || first[other] != other || !(squared < least)) continue;
            least = squared;
            first[point] = other;
        }
        joined += first[point] != point;
    }
    replace_corners(soup, first);
    return joined;
}

bool shares_no_point(const PolygonSoup& soup) {
    constexpr std::size_t none = -1;
    std::vector<std::size_t> user(soup.points.size(), none);
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
        for (const std::size_t corner : soup.polygons[i]) {
            if (user[corner] != none && user[corner] != i) return false;
            user[corner] = i;
        }
    return soup.polygons.size() > 1;
}

}  // namespace sherd
