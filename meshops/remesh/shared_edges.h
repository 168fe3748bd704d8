// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Edges along which a mesh lies on itself without being joined: where more than two faces met at an edge, or
/// along an open seam.
struct SharedEdges {
    std::vector<char> is_shared;  ///< [E] whether another edge has the same two ends
    /// Coincident vertices of such edges, ascending, at least two in a list.
    std::vector<std::vector<Vertex>> coincident;
};

/// Finds the shared edges of a mesh, except those whose faces lie on each other, too, as in a sheet that
/// comes twice.
SharedEdges shared_edges(const Mesh& mesh);

}  // namespace sherd
