// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Removes triangles of zero area (zero_area_triangles()) and joins the triangles beside them, so that no
/// slit is left: corners at one place become one point, and a corner on the opposite side divides the
/// triangle beyond that side, with its texture coordinates. A flat triangle that joins nothing, at a boundary
/// or where more than two meet, is dropped. Triangles of a polygon still follow each other.
void remove_zero_area_triangles(TriangleSoup& soup);

}  // namespace sherd
