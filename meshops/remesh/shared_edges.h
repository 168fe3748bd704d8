// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Edges along which a mesh lies on itself without being joined: where an edge of more than two faces was
/// separated, or along an open seam.
struct SharedEdges {
    std::vector<char> is_shared;  ///< [E] whether another edge has the same two ends
    /// Sets of two or more coincident vertices of such edges, each ascending.
    std::vector<std::vector<Vertex>> coincident;
};

/// Finds the shared edges of a mesh, except edges whose faces coincide, too, as in a sheet that is in the
/// mesh twice.
SharedEdges shared_edges(const Mesh& mesh);

}  // namespace sherd
