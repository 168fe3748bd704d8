// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "meshops/polygon_soup.h"

namespace sherd {

/// Triangles on their way from a file to a Mesh. Three points a triangle, no other promise: any number of
/// triangles may meet at an edge, in any orientation.
struct TriangleSoup {
    std::vector<Point> points;
    std::vector<std::uint32_t> file_vertex;  ///< of each point, its number in the file
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<FaceTexture> texture;  ///< of each triangle; none: empty
    std::vector<std::size_t> polygon;  ///< of each triangle, the polygon of the file it is part of
};

/// Cuts the polygons into triangles, a polygon's triangles together, triangles as they are. Throws Error when
/// a polygon crosses or touches itself. A triangle without texture coordinates beside others that have some
/// gets (0, 0).
TriangleSoup triangulate(const PolygonSoup& soup);

/// Triangles whose area is zero to round-off: repeated or collinear corners. In order.
std::vector<std::size_t> zero_area_triangles(const TriangleSoup& soup);
/// Triangles on the same three points as an earlier one. In order.
std::vector<std::size_t> repeated_triangles(const TriangleSoup& soup);
void erase_triangles(TriangleSoup& soup, const std::vector<std::size_t>& ascending);

/// An edge where three or more triangles meet.
struct NonManifoldEdge {
    std::array<std::uint32_t, 2> points;
    std::vector<std::size_t> triangles;
};
std::vector<NonManifoldEdge> non_manifold_edges(const TriangleSoup& soup);

/// Makes points of their own for what meets in a point or a non-manifold edge without being joined by an edge
/// of two triangles, so that every edge has at most two triangles and every point one fan of them. Returns
/// the points that were doubled, ascending.
std::vector<std::uint32_t> separate(TriangleSoup& soup);

/// Turns triangles over until neighbours agree; of each component the smaller part is turned (on a tie, the
/// part without its first triangle), the first corner stays the first. Expects a soup that is separated.
struct Orientation {
    std::vector<std::size_t> turned;       ///< triangles, ascending
    std::optional<std::size_t> one_sided;  ///< a triangle of a component that has one side only (Moebius)
};
Orientation orient(TriangleSoup& soup);

}  // namespace sherd
