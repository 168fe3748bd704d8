// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/point_grid.h"
#include "meshops/triangle_soup.h"

namespace sherd {

/// Edges of one triangle that lie exactly where others do, without being joined to them: what a crack that
/// was opened looks like, and a seam that a modeller left open. In the order of their points, each as two
/// points.
std::vector<std::array<std::uint32_t, 2>> seam_edges(const TriangleSoup& soup);

/// Edges of one triangle that lie nearly where others do.
struct NearSeams {
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< in the order of their points
    double length = 0;                                ///< of all of them
    double gap = 0;                                   ///< the largest distance of their ends
};
/// Seams that are open by more than nothing and at most `share` of the edge.
NearSeams near_seams(const TriangleSoup& soup, double share);

/// A point on an edge of one triangle, which it does not divide, and which has another end (a T-junction).
struct Junction {
    std::array<std::uint32_t, 2> edge;  ///< ascending
    std::uint32_t point;
    PlaceOnSegment place;
};
/// The T-junctions where the distance is at most `share` of the edge and `distance`, by edge and from its
/// lower end on.
std::vector<Junction> junctions(const TriangleSoup& soup, double share, double distance);

/// Divides edges by the points that are on them (junctions() up to `distance`), with the texture coordinates
/// of their triangles. Returns the number of edges.
std::size_t divide_at_junctions(TriangleSoup& soup, double distance);

}  // namespace sherd
