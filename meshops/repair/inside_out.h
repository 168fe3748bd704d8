// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Triangles of closed components whose normals point inward, ascending: components of negative volume that
/// no other closed component encloses (the normals of a cavity are to point into it). The soup must be the
/// result of separate_sheets() and orient().
std::vector<std::size_t> inside_out_triangles(const TriangleSoup& soup);

}  // namespace sherd
