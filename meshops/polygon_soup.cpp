// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshops/error.h"

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
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
        if (!is_finite(soup.points[i])) {
            throw Error(place_of_point(soup, i) + ": a coordinate is NaN or infinite");
        }
    }
    for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
        for (const std::size_t corner : soup.polygons[i]) {
            if (corner >= soup.points.size()) {
                // The file holds signed numbers, so -1 is shown as -1.
                throw Error(place_of_polygon(soup, i) + ": index out of range: there is no vertex " +
                            std::to_string(static_cast<std::ptrdiff_t>(corner)) + ", the file has " +
                            std::to_string(soup.points.size()) + " (numbered from 0)");
            }
        }
        if (soup.polygons[i].size() < 3) {
            throw Error(place_of_polygon(soup, i) + ": has " + std::to_string(soup.polygons[i].size()) +
                        " corners, a face needs three or more");
        }
    }
}

std::size_t join_duplicate_points(PolygonSoup& soup) {
    std::vector<std::size_t> order(soup.points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        return soup.points[a] != soup.points[b] ? soup.points[a] < soup.points[b] : a < b;
    });
    std::vector<std::size_t> first(order.size());
    std::size_t joined = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool repeats = i > 0 && soup.points[order[i]] == soup.points[order[i - 1]];
        first[order[i]] = repeats ? first[order[i - 1]] : order[i];
        joined += repeats;
    }
    for (auto& polygon : soup.polygons) {
        for (auto& corner : polygon) corner = first[corner];
    }
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
