// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fracture/snapshot.h"

namespace sherd {

/// An edge between two faces at rest that is open or has failed without opening, once however many sides it
/// has now.
struct CrackedEdge {
    std::array<Index, 2> vertices{};     ///< of the mesh at rest, ascending
    std::array<std::size_t, 2> faces{};  ///< on its sides
    double length = 0;                   ///< m, at rest
};

/// A line of cracked edges between two nodes: vertices where cracks end, meet, or come to the rim. One that
/// has no node is closed, and so is one that comes back to its node: its first vertex is its last one.
struct CrackBranch {
    std::vector<Index> vertices;     ///< of the mesh at rest, one more than edges
    std::vector<std::size_t> edges;  ///< of the graph

    bool is_closed() const { return vertices.front() == vertices.back(); }
    /// Whether it is long enough to show more than the mesh, and the dust where that is crushed: three edges,
    /// or six that are closed.
    bool has_shape() const { return edges.size() >= (is_closed() ? 6 : 3); }
};

/// The cracks of a frame as lines on the mesh at rest.
struct CrackGraph {
    std::vector<CrackedEdge> edges;
    std::vector<CrackBranch> branches;  ///< have each edge once
    std::vector<char> on_rim;           ///< [R] whether a vertex at rest lies on the rim of its sheet
    std::vector<Index> degree;          ///< [R] cracked edges at each vertex at rest
};

CrackGraph crack_graph(const Snapshot& frame);

/// Length of all open branches that have a shape, over that of their chords: 1 is straight. Nothing without
/// any.
std::optional<double> tortuosity(const CrackGraph& cracks, const RestMesh& rest);

}  // namespace sherd
