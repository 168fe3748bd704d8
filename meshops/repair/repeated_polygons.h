// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// A polygon that covers the same area as an earlier polygon, as a part of an earlier polygon, or as several
/// polygons of which `earlier` is the first.
struct RepeatedPolygon {
    std::size_t polygon, earlier;
};

/// Finds polygons of four or more corners that repeat an earlier polygon, perhaps with another first corner
/// or turned over; and polygons that together fill another polygon, for example triangles. Returns the
/// repeated polygons, ascending. If a part comes before the polygon that it helps to fill, this polygon
/// counts as repeated; otherwise its parts do.
std::vector<RepeatedPolygon> repeated_polygons(const PolygonSoup& soup);

}  // namespace sherd
