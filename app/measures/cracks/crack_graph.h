// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// An edge between two faces at rest that is open or has failed without opening. It is listed once, however
/// many sides it has now.
struct CrackedEdge {
    std::array<Index, 2> vertices{};     ///< vertices of the mesh at rest, ascending
    std::array<std::size_t, 2> faces{};  ///< faces on both sides
    double length = 0;                   ///< m, at rest
};

/// A line of cracked edges between two nodes: vertices where cracks end, meet, or reach the rim. A line
/// without nodes is closed, and so is one that returns to its node: its first vertex is its last one.
struct CrackBranch {
    std::vector<Index> vertices;     ///< vertices of the mesh at rest, one more than edges
    std::vector<std::size_t> edges;  ///< indices of the graph's edges

    bool is_closed() const { return vertices.front() == vertices.back(); }
    /// Whether it is long enough for a shape that is neither that of single edges of the mesh nor of crushed
    /// regions: three edges or more, or six if closed.
    bool has_shape() const { return edges.size() >= (is_closed() ? 6 : 3); }
};

/// The cracks of a frame as lines on the mesh at rest.
struct CrackGraph {
    std::vector<CrackedEdge> edges;
    std::vector<CrackBranch> branches;  ///< each edge is in one branch
    std::vector<char> on_rim;           ///< [R] whether a vertex at rest lies on the rim of its sheet
    std::vector<Index> degree;          ///< [R] number of cracked edges at each vertex at rest
};

CrackGraph crack_graph(const Snapshot& frame);

/// Length of all open branches that have a shape, over that of their chords: 1 is straight. None without such
/// branches.
std::optional<double> tortuosity(const CrackGraph& cracks, const RestMesh& rest);

}  // namespace sherd
