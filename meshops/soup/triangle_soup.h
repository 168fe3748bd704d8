// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "meshops/soup/polygon_soup.h"

namespace sherd {

/// Triangles of a file before they become a Mesh. Each triangle has three points; nothing else is guaranteed:
/// any number of triangles may meet at an edge, in any orientation.
struct TriangleSoup {
    std::vector<Point> points;
    std::vector<std::uint32_t> file_vertex;  ///< number of each point in the file
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<FaceTexture> texture;  ///< texture coordinates of each triangle; empty if there are none
    std::vector<std::size_t> polygon;  ///< polygon of the file that each triangle is part of
};

/// Cuts polygons into triangles. The triangles of a polygon follow each other; a polygon of three corners
/// becomes one triangle, and a polygon of fewer corners none. A polygon may run along a line twice, as to a
/// hole and back. Throws Error if a polygon crosses or touches itself otherwise. Triangles without texture
/// coordinates get (0, 0) if other triangles have some.
TriangleSoup triangulate(const PolygonSoup& soup);

/// Returns the triangles whose area is zero up to round-off, with repeated or collinear corners, ascending.
std::vector<std::size_t> zero_area_triangles(const TriangleSoup& soup);
/// Returns the triangles that have the same three points as an earlier triangle, ascending.
std::vector<std::size_t> repeated_triangles(const TriangleSoup& soup);
/// Returns the mean position of points as text, "(0.1, 0.02, 0.03)", in the unit of the file.
std::string middle_text(const TriangleSoup& soup, std::span<const std::uint32_t> points);
void erase_triangles(TriangleSoup& soup, const std::vector<std::size_t>& ascending);

/// An edge where three or more triangles meet.
struct NonManifoldEdge {
    std::array<std::uint32_t, 2> points;
    std::vector<std::size_t> triangles;
};
std::vector<NonManifoldEdge> non_manifold_edges(const TriangleSoup& soup);

/// Result of orient(), which turns triangles over until neighbours have the same orientation. In each
/// component, the triangles of the less frequent orientation are turned over (if both are equally frequent,
/// those that differ from the first triangle); the first corner of a triangle stays the first. If a component
/// is one-sided, no triangle is turned over. The soup must be the result of separate_sheets().
struct Orientation {
    std::vector<std::size_t> turned;       ///< triangles to be turned over, ascending
    std::optional<std::size_t> one_sided;  ///< a triangle of a one-sided component (Moebius strip)
};
Orientation orient(TriangleSoup& soup);
/// Turns a triangle over; its first corner stays the first.
void reverse_triangle(TriangleSoup& soup, std::size_t triangle);

/// A side of a triangle of a soup, with its points in ascending order.
struct SoupSide {
    std::uint32_t low, high;
    std::size_t triangle;
    int corner;      ///< number of the corner where the side starts
    bool is_rising;  ///< whether the side starts at `low`

    auto edge() const { return std::tuple(low, high); }
    auto key() const { return std::tuple(low, high, triangle, corner); }
};

/// Calls visit(sides) for each edge of a soup, with the sides of all triangles at the edge, in the order of
/// the triangles.
template <typename Visit>
void for_each_soup_edge(const TriangleSoup& soup, Visit visit) {
    std::vector<SoupSide> sides;
    sides.reserve(3 * soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto a = soup.triangles[t][corner], b = soup.triangles[t][(corner + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, corner, a < b});
        }
    }
    std::ranges::sort(sides, {}, &SoupSide::key);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && sides[end].edge() == sides[begin].edge()) ++end;
        visit(std::span<const SoupSide>(sides).subspan(begin, end - begin));
    }
}

}  // namespace sherd
