// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Duplicates points so that every edge has at most two triangles and the triangles at every point form one
/// fan. Where more than two triangles meet at an edge, pairs of them stay joined. First come pairs that agree
/// in orientation; among these, pairs that are also connected elsewhere; then pairs with the smallest
/// dihedral angle; then pairs that bend away from their normals, as where two boxes touch along an edge. Two
/// pairs with a common triangle that are equal in all of this are both separated. Where a triangle has no
/// partner, the edge becomes a boundary. Parts that share only a point get a point each. Returns the points
/// that were duplicated, ascending.
std::vector<std::uint32_t> separate_sheets(TriangleSoup& soup);

}  // namespace sherd
