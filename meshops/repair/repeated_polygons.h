// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// A polygon that repeats an earlier one, wholly or in part.
struct RepeatedPolygon {
    std::size_t polygon, earlier;
};

/// Finds polygons of four or more corners that repeat an earlier one, with another first corner or turned
/// over, and polygons that together repeat another one in parts, as its triangles do; ascending. If a part
/// comes before its polygon, the polygon counts as repeated, otherwise the parts do.
std::vector<RepeatedPolygon> repeated_polygons(const PolygonSoup& soup);

}  // namespace sherd
