// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/triangle_soup.h"

namespace sherd {

/// A polygon that covers what an earlier one covers.
struct RepeatedPolygon {
    std::size_t polygon, earlier;
};

/// Polygons of four or more corners that are there already, beginning with another corner or turned over, and
/// polygons that repeat another one in parts, as its triangles do; ascending. Of a polygon and its parts what
/// comes later repeats.
std::vector<RepeatedPolygon> repeated_polygons(const PolygonSoup& soup);

}  // namespace sherd
