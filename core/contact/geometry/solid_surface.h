// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// The surface of what sheets do not pass through, as triangles in a frame of its own. Empty of what has no
/// corner and no edge: of a plane, the vertices of a sheet say all.
struct SolidSurface {
    Positions points = Positions(3, 0);           ///< [3, P] m
    std::vector<std::array<Index, 3>> triangles;  ///< of points
    // What follows from these:
    VectorXd footprint;                       ///< [P] m^2, area of the surface that is nearest to the point
    std::vector<std::array<Index, 2>> edges;  ///< ascending; but for those that triangles of one plane share
    std::vector<double> width;                ///< m, of each edge: the area nearest to it over its length

    Index size() const { return static_cast<Index>(points.cols()); }
};

/// points: [3, P] m. Throws std::out_of_range if a triangle has a point that there is not.
SolidSurface solid_surface(Positions points, std::vector<std::array<Index, 3>> triangles);

}  // namespace sherd
