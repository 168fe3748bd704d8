// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repair/inside_out.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/disjoint_sets.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

struct Component {
    std::vector<std::size_t> triangles;
    bool is_closed = true;
    CGAL::Bbox_3 box;
};

std::vector<Component> components(const TriangleSoup& soup) {
    DisjointSets sets(soup.triangles.size());
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() == 2) sets.join(sides[0].triangle, sides[1].triangle);
    });
    std::vector<Component> result;
    std::vector<std::size_t> number(soup.triangles.size());
    for (std::size_t t = 0; t < number.size(); ++t) {
        if (sets.find(t) == t) {
            number[t] = result.size();
            result.emplace_back();
        } else {
            number[t] = number[sets.find(t)];
        }
        result[number[t]].triangles.push_back(t);
        for (const auto point : soup.triangles[t]) result[number[t]].box += soup.points[point].bbox();
    }
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() == 1) result[number[sides[0].triangle]].is_closed = false;
    });
    return result;
}

/// Whether the volume within a closed component is negative by more than round-off.
bool has_negative_volume(const TriangleSoup& soup, const Component& component) {
    const Point& origin = soup.points[soup.triangles[component.triangles[0]][0]];
    double volume = 0, size = 0;
    for (const std::size_t t : component.triangles) {
        const auto& [a, b, c] = soup.triangles[t];
        const auto p = soup.points[a] - origin, q = soup.points[b] - origin, r = soup.points[c] - origin;
        const double part = CGAL::cross_product(p, q) * r;
        volume += part, size += std::abs(part);
    }
    return volume < -1e-9 * size;
}

/// Returns the winding number of a closed component about a point: the solid angle of the component seen from
/// the point, divided by 4 pi (van Oosterom and Strackee 1983).
double winding_number(const TriangleSoup& soup, const Component& component, const Point& point) {
    double sum = 0;
    for (const std::size_t t : component.triangles) {
        const auto& [i, j, k] = soup.triangles[t];
        const auto a = soup.points[i] - point, b = soup.points[j] - point, c = soup.points[k] - point;
        const double x = std::sqrt(a.squared_length()), y = std::sqrt(b.squared_length()),
                     z = std::sqrt(c.squared_length());
        sum += 2 *
               std::atan2(CGAL::cross_product(a, b) * c, x * y * z + (a * b) * z + (b * c) * x + (c * a) * y);
    }
    return sum / (4 * std::numbers::pi);
}

bool goes_around(const TriangleSoup& soup, const Component& outer, const Component& inner) {
    for (int i = 0; i < 3; ++i)
        if (outer.box.min(i) > inner.box.min(i) || outer.box.max(i) < inner.box.max(i)) return false;
    const Point& point = soup.points[soup.triangles[inner.triangles[0]][0]];
    return std::abs(winding_number(soup, outer, point)) > 0.5;
}

}  // namespace

std::vector<std::size_t> inside_out_triangles(const TriangleSoup& soup) {
    const std::vector<Component> all = components(soup);
    std::vector<std::size_t> result;
    for (const Component& component : all) {
        if (!component.is_closed || !has_negative_volume(soup, component)) continue;
        const bool is_within = std::ranges::any_of(all, [&](const Component& other) {
            return &other != &component && other.is_closed && goes_around(soup, other, component);
        });
        if (!is_within) result.insert(result.end(), component.triangles.begin(), component.triangles.end());
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace sherd
