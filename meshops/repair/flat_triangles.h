// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Removes flat triangles, which have zero area (zero_area_triangles()), and joins the triangles around them,
/// so that no slit is left. Coincident corners of a flat triangle become one point. A corner on the opposite
/// side of a flat triangle divides the triangle across that side, and texture coordinates are interpolated. A
/// flat triangle that joins nothing, since a side is on the boundary or belongs to more than two triangles,
/// is dropped. Triangles of a polygon still follow each other.
void remove_zero_area_triangles(TriangleSoup& soup);

}  // namespace sherd
