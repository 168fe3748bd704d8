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

ContactSurface::ContactSurface(const Sheet& sheet) : sheet(&sheet), has_twin(sheet.rest.cols(), 0) {
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
        twin.push_back({a, b});
        twin.push_back({b, a});
        has_twin[a] = has_twin[b] = 1;
    }
    std::sort(twin.begin(), twin.end());
}

bool ContactSurface::joined(Index a, Index b) const {
    return a == b ||
           (has_twin[a] && has_twin[b] && std::binary_search(twin.begin(), twin.end(), std::array{a, b}));
}

bool ContactSurface::apart(PairKind kind, const std::array<Index, 4>& vertices) const {
    const int first = vertices_of_first(kind);
    for (int i = 0; i < first; ++i)
        for (int j = first; j < 4; ++j)
            if (joined(vertices[i], vertices[j])) return true;
    return false;
}

double ContactSurface::thickness(PairKind kind, const std::array<Index, 4>& vertices) const {
    return half_thickness(vertices[0]) + half_thickness(vertices[vertices_of_first(kind)]);
}

double ContactSurface::touching(PairKind kind, const std::array<Index, 4>& vertices) const {
    const double together = thickness(kind, vertices);
    if (sheet->body[vertices[0]] != sheet->body[vertices[vertices_of_first(kind)]]) return together;
    const PairPositions rest = pair_positions(sheet->rest, vertices);
    const double at_rest = std::sqrt(squared_distance(closest_points(kind, rest), rest));
    // Lips of a crack have no distance at rest; they have been left to the barrier by whoever opened it.
    return at_rest > 0 ? std::min(together, share_of_rest * at_rest) : together;
}

double ContactSurface::edge_width(Index a, Index b) const {
    const auto found = std::lower_bound(edge.begin(), edge.end(), std::array{a, b});
    return width[found - edge.begin()];
}

ContactPair ContactSurface::pair(PairKind kind, const std::array<Index, 4>& vertices, double touching) const {
    const auto [a, b, c, d] = vertices;
    const bool edges = kind == PairKind::edge_edge;
    const double area =
        edges ? std::numbers::pi / 2 * edge_width(a, b) * edge_width(c, d) : sheet->footprint[a];
    const Index other = vertices[vertices_of_first(kind)];
    const double column = half_thickness(a) / sheet->young[a] + half_thickness(other) / sheet->young[other];
    return {kind, vertices, share * area / column, touching,
            edges ? edge_mollifier(rest_length(a, b), rest_length(c, d)) : EdgeMollifier{}};
}

}  // namespace sherd
