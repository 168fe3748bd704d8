// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/contact_surface.h"

#include <algorithm>
#include <numbers>

namespace sherd {
namespace {

constexpr double share = 0.5;           // of a column, for each way of touching
constexpr double share_of_rest = 0.75;  // of the distance at rest, from which neighbours push

/// A side of a triangle, and a third of the triangle's area.
struct Side {
    std::array<Index, 2> ends;
    double area;
    bool operator<(const Side& other) const { return ends < other.ends; }
};

std::vector<Side> sorted_sides(const Sheet& sheet) {
    std::vector<Side> sides;
    for (const TriangleStencil& triangle : sheet.triangles)
        for (int i = 0; i < 3; ++i) {
            const auto [low, high] = std::minmax(triangle.vertices[i], triangle.vertices[(i + 1) % 3]);
            sides.push_back({{low, high}, triangle.membrane.area / 3});
        }
    std::stable_sort(sides.begin(), sides.end());
    return sides;
}

}  // namespace

ContactSurface::ContactSurface(const Sheet& sheet) : sheet(&sheet) {
    for (const TriangleStencil& stencil : sheet.triangles) triangle.push_back(stencil.vertices);
    const std::vector<Side> sides = sorted_sides(sheet);
    for (std::size_t i = 0; i < sides.size();) {
        const auto [a, b] = sides[i].ends;
        double area = 0;
        int count = 0;
        for (; i < sides.size() && sides[i].ends == std::array{a, b}; ++i, ++count) area += sides[i].area;
        edge.push_back({a, b});
        width.push_back(area / (sheet.rest.col(a) - sheet.rest.col(b)).norm() +
                        (count == 1 ? sheet.thickness[a] : 0));
    }
    for (const auto& [a, b] : sheet.twins) {
        twins.push_back({a, b});
        twins.push_back({b, a});
    }
    std::sort(twins.begin(), twins.end());
}

bool ContactSurface::joined(Index a, Index b) const {
    return a == b || std::binary_search(twins.begin(), twins.end(), std::array{a, b});
}

bool ContactSurface::apart(Index vertex, Index face) const {
    const auto& corners = triangle[face];
    return std::any_of(corners.begin(), corners.end(), [&](Index corner) { return joined(vertex, corner); });
}

bool ContactSurface::edges_apart(Index edge0, Index edge1) const {
    for (const Index a : edge[edge0])
        for (const Index b : edge[edge1])
            if (joined(a, b)) return true;
    return false;
}

ContactPair ContactSurface::vertex_triangle(Index vertex, Index face) const {
    const auto [a, b, c] = triangle[face];
    ContactPair pair{PairKind::vertex_triangle, {vertex, a, b, c}, 0, 0, {}};
    fill(pair, vertex, a, sheet->footprint[vertex]);
    return pair;
}

ContactPair ContactSurface::edge_edge(Index edge0, Index edge1) const {
    const auto [a, b] = edge[edge0];
    const auto [c, d] = edge[edge1];
    const auto length = [&](Index i, Index j) { return (sheet->rest.col(i) - sheet->rest.col(j)).norm(); };
    ContactPair pair{PairKind::edge_edge, {a, b, c, d}, 0, 0, edge_mollifier(length(a, b), length(c, d))};
    fill(pair, a, c, std::numbers::pi / 2 * width[edge0] * width[edge1]);
    return pair;
}

void ContactSurface::fill(ContactPair& pair, Index a, Index b, double area) const {
    const double column = half_thickness(a) / sheet->young[a] + half_thickness(b) / sheet->young[b];
    pair.stiffness = share * area / column;
    pair.touching = half_thickness(a) + half_thickness(b);
    if (sheet->body[a] != sheet->body[b]) return;
    const double at_rest = distance(pair, pair_positions(sheet->rest, pair.vertices));
    // Lips of a crack have no distance at rest; they have been left to the barrier by whoever opened it.
    if (at_rest > 0) pair.touching = std::min(pair.touching, share_of_rest * at_rest);
}

}  // namespace sherd
