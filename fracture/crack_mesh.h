// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "fracture/edge_state.h"
#include "meshops/topology_change.h"

namespace sherd {

/// A mesh whose edges fail and open: the state machine of the paper's appendix B, with no physics.
/// Two corners of one original vertex are the same vertex if and only if one can walk between them around
/// that vertex crossing interior edges only; a failed edge is open if and only if its two sides differ at one
/// end.
class CrackMesh {
  public:
    explicit CrackMesh(Mesh mesh);

    const Mesh& mesh() const { return halfedges; }
    EdgeState state(Edge edge) const { return states[edge]; }
    /// Ancestry: the vertex of the uncut mesh that `vertex` is, or is a copy of; and the same of an edge.
    Vertex original(Vertex vertex) const { return vertex_origin[vertex]; }
    Edge original(Edge edge) const { return edge_origin[edge]; }
    /// Whether a crack ends at `vertex`, inside the sheet: a single failed edge leads there.
    bool is_tip(Vertex vertex) const;

    /// What the failure of some edges did.
    struct Change {
        std::vector<int> boundary_vertices;  ///< of each failed edge: 0, 1, 2 for the paper's B0, B1, B2
        TopologyChange topology;
    };

    /// Lets `edges` fail at once and opens the mesh where it can. B0, B1, B2 count each edge's end points
    /// that lie on another failed or boundary edge, with all of `edges` failed, before any of them opens; so
    /// nothing depends on their order. Throws Error naming the edge when one is not interior or given twice.
    Change fail(std::span<const Edge> edges);

  private:
    int boundary_vertices(Edge edge) const;

    Mesh halfedges;
    std::vector<EdgeState> states;
    std::vector<Vertex> vertex_origin;
    std::vector<Edge> edge_origin;
};

}  // namespace sherd
