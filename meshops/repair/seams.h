// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/point_grid.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Finds boundary edges that lie exactly on others without being joined to them, as along a crack that was
/// opened, or a seam that a modeller left open. Each edge is two points; edges are in the order of these.
std::vector<std::array<std::uint32_t, 2>> seam_edges(const TriangleSoup& soup);

/// Boundary edges that lie nearly on others.
struct NearSeams {
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< in the order of their points
    double length = 0;                                ///< total length
    double gap = 0;                                   ///< largest distance between their ends
};
/// Finds seams with a gap above 0 and at most `share` of the edge's length.
NearSeams near_seams(const TriangleSoup& soup, double share);

/// A point on a boundary edge, between the edge's ends, that does not divide the edge (a T-junction).
struct Junction {
    std::array<std::uint32_t, 2> edge;  ///< ascending
    std::uint32_t point;
    PlaceOnSegment place;
};
/// Finds T-junctions whose distance from the edge is at most `distance` and at most `share` of the edge's
/// length; in the order of edges, and along each from its lower end.
std::vector<Junction> junctions(const TriangleSoup& soup, double share, double distance);

/// Divides edges at the points on them (junctions() up to `distance`) and interpolates texture coordinates.
/// Returns the number of divided edges.
std::size_t split_at_junctions(TriangleSoup& soup, double distance);

}  // namespace sherd
