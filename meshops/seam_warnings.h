// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "meshops/read_mesh.h"
#include "meshops/triangle_soup.h"

namespace sherd {

/// Returns sentences on where a sheet is open although it does not look so: edges that lie on each other,
/// edges that nearly do, and vertices on edges that they do not divide, with advice to join them. There are
/// none if the options have no advice.
std::vector<std::string> seam_warnings(const TriangleSoup& soup, const ReadMeshOptions& options);

}  // namespace sherd
