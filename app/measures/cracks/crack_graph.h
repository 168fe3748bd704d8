// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// An edge of the mesh at rest, between two faces, that has opened or has failed without opening. The edge is
/// listed once, even if each of the two faces has its own edge now.
struct CrackedEdge {
    std::array<Index, 2> vertices{};     ///< vertices of the mesh at rest, ascending
    std::array<std::size_t, 2> faces{};  ///< faces on both sides
    double length = 0;                   ///< m, at rest
};

/// A line of cracked edges between two nodes, which are vertices where cracks end, meet or reach the rim. A
/// line is closed, with equal first and last vertices, if it has no nodes or returns to the node where it
/// begins.
struct CrackBranch {
    std::vector<Index> vertices;     ///< vertices of the mesh at rest along the line, one more than edges
    std::vector<std::size_t> edges;  ///< indices in CrackGraph::edges

    bool is_closed() const { return vertices.front() == vertices.back(); }
    /// Whether the branch is long enough to have a shape of its own: three edges, or six if closed. Shorter
    /// branches only show single edges of the mesh, or outline crushed regions.
    bool has_shape() const { return edges.size() >= (is_closed() ? 6 : 3); }
};

/// The cracks of a frame as lines on the mesh at rest.
struct CrackGraph {
    std::vector<CrackedEdge> edges;
    std::vector<CrackBranch> branches;  ///< each edge is in exactly one branch
    std::vector<char> on_rim;           ///< [R] whether each vertex at rest lies on the rim of its sheet
    std::vector<Index> degree;          ///< [R] number of cracked edges at each vertex at rest
};

CrackGraph crack_graph(const Snapshot& frame);

/// Returns the total length of the open branches that have a shape, divided by the total length of their
/// chords; 1 if all are straight. None if there are no such branches.
std::optional<double> tortuosity(const CrackGraph& cracks, const RestMesh& rest);

}  // namespace sherd
