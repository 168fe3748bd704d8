// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Duplicates points so that every edge has at most two triangles and every point one fan of them. Where more
/// than two triangles meet at an edge, pairs of them stay joined: first pairs that agree in orientation, then
/// those that are also connected elsewhere, then those with the smallest dihedral angle; among equals, those
/// that bend away from their normals, as in two boxes that touch along an edge. Where two pairs are equal in
/// all of this, and for triangles left over, the edge becomes a boundary. Parts that share only a point get
/// one each. Returns the points that were duplicated, ascending.
std::vector<std::uint32_t> separate_sheets(TriangleSoup& soup);

}  // namespace sherd
