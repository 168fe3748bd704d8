// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/triangle_soup.h"

namespace sherd {

/// The triangles of closed components whose normals point inward, ascending: the volume within is negative,
/// and no other closed component goes around (a cavity's normals point into it). The soup must be the result
/// of separate_sheets() and orient().
std::vector<std::size_t> inside_out_triangles(const TriangleSoup& soup);

}  // namespace sherd
