// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repair/flat_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshops/disjoint_sets.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

/// Joins coincident corners of triangles of zero area (flat triangles).
void join_corners(TriangleSoup& soup) {
    DisjointSets points(soup.points.size());
    for (const std::size_t t : zero_area_triangles(soup))
        for (int i = 0; i < 3; ++i) {
            const auto a = soup.triangles[t][i], b = soup.triangles[t][(i + 1) % 3];
            if (soup.points[a] == soup.points[b]) points.join(a, b);
        }
    for (auto& triangle : soup.triangles)
        for (auto& point : triangle) point = static_cast<std::uint32_t>(points.find(point));
}

void erase_collapsed(TriangleSoup& soup) {
    std::vector<std::size_t> collapsed;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        if (a == b || b == c || c == a) collapsed.push_back(t);
    }
    erase_triangles(soup, collapsed);
}

/// Returns the number of the corner where the longest side of a triangle starts.
int longest_side(const TriangleSoup& soup, std::size_t triangle) {
    std::array<double, 3> squared{};
    for (int i = 0; i < 3; ++i)
        squared[i] = CGAL::squared_distance(soup.points[soup.triangles[triangle][i]],
                                            soup.points[soup.triangles[triangle][(i + 1) % 3]]);
    return static_cast<int>(std::ranges::max_element(squared) - squared.begin());
}

/// Divides the triangle across the longest side of a flat triangle at the third corner of the flat triangle,
/// which lies on that side. beyond: that side in the triangle to be divided. The flat triangle becomes one of
/// the two halves.
void divide(TriangleSoup& soup, std::size_t flat, const SoupSide& beyond) {
    const int start = beyond.corner, end = (start + 1) % 3;
    const std::uint32_t middle = soup.triangles[flat][(longest_side(soup, flat) + 2) % 3];
    auto& first = soup.triangles[beyond.triangle];
    const Point& from = soup.points[first[start]];
    const auto along = soup.points[first[end]] - from;
    const double share = std::clamp((soup.points[middle] - from) * along / along.squared_length(), 0.0, 1.0);
    auto& second = soup.triangles[flat] = first;
    first[end] = second[start] = middle;
    soup.polygon[flat] = soup.polygon[beyond.triangle];
    // The half with the start of the side keeps the lower number.
    if (flat < beyond.triangle) std::swap(first, second);
    if (soup.texture.empty()) return;
    FaceTexture& texture = soup.texture[beyond.triangle];
    soup.texture[flat] = texture;
    const Eigen::Vector2d between = (1 - share) * texture[start] + share * texture[end];
    texture[end] = soup.texture[flat][start] = between;
    if (flat < beyond.triangle) std::swap(texture, soup.texture[flat]);
}

/// Divides the triangles across the longest sides of flat triangles, each triangle at most once. Returns the
/// flat triangles that join nothing: no triangle is across the longest side, or none is across the two other
/// sides.
std::vector<std::size_t> divide_beyond(TriangleSoup& soup, const std::vector<std::size_t>& flat) {
    std::vector<bool> is_flat(soup.triangles.size(), false), is_changed(soup.triangles.size(), false);
    std::vector<bool> has_beyond(soup.triangles.size(), false), has_beside(soup.triangles.size(), false);
    for (const std::size_t t : flat) is_flat[t] = true;
    struct Division {
        std::size_t flat;
        SoupSide beyond;
    };
    std::vector<Division> divisions;
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() != 2) return;
        for (const int i : {0, 1}) {
            const SoupSide& side = sides[i];
            if (!is_flat[side.triangle]) continue;
            const bool is_longest = longest_side(soup, side.triangle) == side.corner;
            (is_longest ? has_beyond : has_beside)[side.triangle] = true;
            if (!is_longest) continue;
            divisions.push_back({side.triangle, sides[1 - i]});
        }
    });
    std::ranges::sort(divisions, {}, &Division::flat);
    for (const auto& [t, beyond] : divisions) {
        if (!has_beside[t] || is_changed[t] || is_changed[beyond.triangle]) continue;
        is_changed[t] = is_changed[beyond.triangle] = true;
        divide(soup, t, beyond);
    }
    std::vector<std::size_t> alone;
    std::ranges::copy_if(flat, std::back_inserter(alone),
                         [&](std::size_t t) { return !(has_beyond[t] && has_beside[t]); });
    return alone;
}

void order_by_polygon(TriangleSoup& soup) {
    std::vector<std::size_t> order(soup.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t t) { return soup.polygon[t]; });
    const TriangleSoup old = soup;
    for (std::size_t t = 0; t < order.size(); ++t) {
        soup.triangles[t] = old.triangles[order[t]];
        soup.polygon[t] = old.polygon[order[t]];
        if (!old.texture.empty()) soup.texture[t] = old.texture[order[t]];
    }
}

}  // namespace

void remove_zero_area_triangles(TriangleSoup& soup) {
    // A division can only leave shorter flat triangles. So many rounds are enough for any chain of flat
    // triangles that was not constructed to need more.
    constexpr int most_rounds = 1000;
    for (int round = 0; round < most_rounds; ++round) {
        join_corners(soup);
        erase_collapsed(soup);
        const auto flat = zero_area_triangles(soup);
        if (flat.empty()) break;
        erase_triangles(soup, divide_beyond(soup, flat));
    }
    erase_triangles(soup, zero_area_triangles(soup));
    order_by_polygon(soup);
}

}  // namespace sherd
