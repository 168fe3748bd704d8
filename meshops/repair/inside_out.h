// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

/// Returns the triangles, ascending, of closed components that are inside out: their volume is negative and
/// no other closed component encloses them. (An enclosed component of negative volume is a cavity, whose
/// normals rightly point into it.) The soup must be the result of separate_sheets() and orient().
std::vector<std::size_t> inside_out_triangles(const TriangleSoup& soup);

}  // namespace sherd
