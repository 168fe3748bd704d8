// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/triangle_soup.h"

namespace sherd {

/// Duplicates points so that every edge has at most two triangles and every point one fan of them. Where more
/// than two triangles meet at an edge, those go on as one sheet, two by two, that agree in orientation, then
/// those that are joined elsewhere, too, then those that bend least from one to the other; of equal ones
/// those that bend away from their normals, as of two boxes that touch along an edge. Where two pairs are
/// equal in all of that, and for triangles left over, the edge is a boundary. Parts that share only a point
/// get one each. Returns the points that were duplicated, ascending.
std::vector<std::uint32_t> separate_sheets(TriangleSoup& soup);

}  // namespace sherd
