// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// The surface of a collider, as triangles in the collider's own frame. It is empty for a plane, since
/// contact of the sheets' vertices with the plane is enough.
struct ColliderSurface {
    Positions points = Positions(3, 0);           ///< [3, P] m
    std::vector<std::array<Index, 3>> triangles;  ///< numbers of the three points of each triangle
    // The following members are derived from `points` and `triangles`:
    VectorXd footprint;                       ///< [P] m^2, area of the surface that is nearest to each point
    std::vector<std::array<Index, 2>> edges;  ///< ascending, without the edges between coplanar
                                              ///< triangles, unless the triangles may bend
    std::vector<double> width;  ///< m, for each edge: the area nearest to the edge over its length

    Index size() const { return static_cast<Index>(points.cols()); }
};

/// The surface of `triangles` on `points` ([3, P] m). deforms: whether triangles that are coplanar at these
/// points may bend later. Throws std::out_of_range if a triangle refers to a missing point.
ColliderSurface collider_surface(Positions points, std::vector<std::array<Index, 3>> triangles,
                                 bool deforms = false);

}  // namespace sherd
