// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fracture/edge_state.h"
#include "meshops/topology_change.h"

namespace sherd {

/// A mesh whose edges fail and open: the state machine of the paper's appendix B, without physics. Two
/// corners of one original vertex share a vertex if and only if they are connected around it across interior
/// edges only. A failed edge is open if and only if its two sides have different vertices at one end.
class CrackMesh {
  public:
    explicit CrackMesh(Mesh mesh);

    const Mesh& mesh() const { return halfedges; }
    EdgeState state(Edge edge) const { return states[edge]; }
    /// The vertex of the uncut mesh that `vertex` is, or is a copy of; edges likewise.
    Vertex original(Vertex vertex) const { return vertex_origin[vertex]; }
    Edge original(Edge edge) const { return edge_origin[edge]; }
    /// Whether a crack ends at `vertex` inside the sheet: exactly one failed edge leads there.
    bool is_tip(Vertex vertex) const;

    /// What the failure of some edges changed.
    struct Change {
        std::vector<int> boundary_vertices;  ///< of each failed edge: 0, 1 or 2 for the paper's B0, B1 or B2
        TopologyChange topology;
    };

    /// Makes `edges` fail at once and opens the mesh where possible. B0, B1 and B2 count the ends of each
    /// edge that lie on another failed or boundary edge, with all of `edges` failed and none of them open
    /// yet, so that nothing depends on their order. Throws Error naming the edge if one is not interior or is
    /// given twice.
    Change fail(std::span<const Edge> edges);

  private:
    int boundary_vertices(Edge edge) const;

    Mesh halfedges;
    std::vector<EdgeState> states;
    std::vector<Vertex> vertex_origin;
    std::vector<Edge> edge_origin;
};

}  // namespace sherd
