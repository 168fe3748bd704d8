// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/soup/triangle_soup.h"

#include <algorithm>
#include <cmath>

#include "meshops/number_text.h"

namespace sherd {
namespace {

/// A neighbour of a triangle across an edge of two triangles, and whether both have the same orientation.
struct Neighbour {
    std::size_t triangle;
    bool agrees;
};

std::vector<std::vector<Neighbour>> neighbours(const TriangleSoup& soup) {
    std::vector<std::vector<Neighbour>> result(soup.triangles.size());
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() != 2) return;
        const bool agrees = sides[0].is_rising != sides[1].is_rising;
        result[sides[0].triangle].push_back({sides[1].triangle, agrees});
        result[sides[1].triangle].push_back({sides[0].triangle, agrees});
    });
    return result;
}

}  // namespace

std::vector<std::size_t> zero_area_triangles(const TriangleSoup& soup) {
    // Corners are collinear up to round-off if the height is below this share of the longest side.
    constexpr double least_height = 1e-12;
    std::vector<std::size_t> result;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        const auto u = soup.points[b] - soup.points[a], v = soup.points[c] - soup.points[a], w = v - u;
        const double longest = std::max({u.squared_length(), v.squared_length(), w.squared_length()});
        const double twice_area = std::sqrt(CGAL::cross_product(u, v).squared_length());
        if (!(twice_area > least_height * longest)) result.push_back(t);
    }
    return result;
}

std::vector<std::size_t> repeated_triangles(const TriangleSoup& soup) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::size_t>> sorted;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        sorted.emplace_back(soup.triangles[t], t);
        std::ranges::sort(sorted.back().first);
    }
    std::ranges::sort(sorted);
    std::vector<std::size_t> result;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first == sorted[i - 1].first) result.push_back(sorted[i].second);
    }
    std::ranges::sort(result);
    return result;
}

std::string middle_text(const TriangleSoup& soup, std::span<const std::uint32_t> points) {
    std::array<double, 3> sum{};
    for (const std::uint32_t point : points)
        for (int i = 0; i < 3; ++i) sum[i] += soup.points[point][i];
    const auto mean = [&](int i) { return number_text(sum[i] / static_cast<double>(points.size())); };
    return "(" + mean(0) + ", " + mean(1) + ", " + mean(2) + ")";
}

void erase_triangles(TriangleSoup& soup, const std::vector<std::size_t>& ascending) {
    const auto erase = [&](auto& values) {
        if (values.empty()) return;
        std::size_t kept = 0;
        auto next = ascending.begin();
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (next != ascending.end() && *next == i) {
                ++next;
            } else {
                values[kept++] = values[i];
            }
        }
        values.resize(kept);
    };
    erase(soup.triangles);
    erase(soup.texture);
    erase(soup.polygon);
}

std::vector<NonManifoldEdge> non_manifold_edges(const TriangleSoup& soup) {
    std::vector<NonManifoldEdge> result;
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() < 3) return;
        result.push_back({{sides[0].low, sides[0].high}, {}});
        for (const SoupSide& side : sides) result.back().triangles.push_back(side.triangle);
    });
    return result;
}

void reverse_triangle(TriangleSoup& soup, std::size_t triangle) {
    std::swap(soup.triangles[triangle][1], soup.triangles[triangle][2]);
    if (!soup.texture.empty()) std::swap(soup.texture[triangle][1], soup.texture[triangle][2]);
}

Orientation orient(TriangleSoup& soup) {
    const auto adjacent = neighbours(soup);
    Orientation result;
    enum class State : char { unvisited, kept, turned };
    std::vector<State> state(soup.triangles.size(), State::unvisited);
    for (std::size_t seed = 0; seed < state.size(); ++seed) {
        if (state[seed] != State::unvisited) continue;
        state[seed] = State::kept;
        std::vector<std::size_t> component{seed};
        for (std::size_t i = 0; i < component.size(); ++i) {
            for (const auto& [other, agrees] : adjacent[component[i]]) {
                const bool is_turned = (state[component[i]] == State::turned) == agrees;
                const State wanted = is_turned ? State::turned : State::kept;
                if (state[other] == State::unvisited) {
                    state[other] = wanted;
                    component.push_back(other);
                } else if (state[other] != wanted && !result.one_sided) {
                    result.one_sided = component[i];
                }
            }
        }
        const auto turned = static_cast<std::size_t>(
            std::ranges::count_if(component, [&](std::size_t t) { return state[t] == State::turned; }));
        const State smaller = 2 * turned > component.size() ? State::kept : State::turned;
        std::ranges::copy_if(component, std::back_inserter(result.turned),
                             [&](std::size_t t) { return state[t] == smaller; });
    }
    std::ranges::sort(result.turned);
    if (result.one_sided) return result;
    for (const std::size_t triangle : result.turned) reverse_triangle(soup, triangle);
    return result;
}

}  // namespace sherd
