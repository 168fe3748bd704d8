// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/point_grid.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Finds boundary edges that lie exactly on other boundary edges without being joined to them, as along an
/// opened crack, or along a seam that a modelling program left open. Returns the two points of each edge, in
/// the order of the edges.
std::vector<std::array<std::uint32_t, 2>> seam_edges(const TriangleSoup& soup);

/// Boundary edges that nearly lie on other boundary edges.
struct NearSeams {
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< two points of each edge, ascending
    double length = 0;                                ///< total length of these edges, in units of the file
    double gap = 0;                                   ///< largest gap to the other edge, in units of the file
};
/// Finds the boundary edges whose gap to the nearest other boundary edge is above 0 and at most `share` of
/// their length. The gap is the larger of the two distances between corresponding ends of the edges.
NearSeams near_seams(const TriangleSoup& soup, double share);

/// A point on a boundary edge, between the edge's ends, that does not divide the edge (a T-junction).
struct Junction {
    std::array<std::uint32_t, 2> edge;  ///< the two points of the edge, ascending
    std::uint32_t point;
    PlaceOnSegment place;
};
/// Finds T-junctions: points whose distance from an edge is at most `distance`, and at most `share` of the
/// length of the edge. They are in the order of their edges and, along each edge, in their order from its
/// lower end.
std::vector<Junction> junctions(const TriangleSoup& soup, double share, double distance);

/// Divides edges, and the triangles at them, at the points on them (junctions() up to `distance`), and
/// interpolates texture coordinates. Returns the number of divided edges.
std::size_t split_at_junctions(TriangleSoup& soup, double distance);

}  // namespace sherd
