// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "meshops/read_mesh.h"
#include "meshops/triangle_soup.h"

namespace sherd {

/// Returns warnings about seams, where a sheet is open although it looks closed: edges that lie on each
/// other, edges that nearly do, and vertices on edges that they do not divide, each with advice to join them.
/// Returns none if `options.join_advice` is empty.
std::vector<std::string> seam_warnings(const TriangleSoup& soup, const ReadMeshOptions& options);

}  // namespace sherd
