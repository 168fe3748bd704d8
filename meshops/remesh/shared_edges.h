// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Where a mesh lies on itself along edges that are not joined: where more than two faces met at an edge, or
/// along an open seam.
struct SharedEdges {
    std::vector<char> is_shared;  ///< [E] whether another edge has the same two ends
    /// Vertices of such edges that are at one place, ascending, at least two in a list.
    std::vector<std::vector<Vertex>> together;
};

/// Edges whose faces lie on each other, too, as of a sheet that comes twice, are not meant.
SharedEdges shared_edges(const Mesh& mesh);

}  // namespace sherd
