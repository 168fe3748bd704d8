// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/state_visitor.h"
#include "meshops/topology/advance/advance_edge.h"

namespace sherd {

/// State of an edge (paper, appendix B). It only increases.
enum class EdgeState : std::uint8_t {
    interior = 0,            ///< has a hinge
    fractured_interior = 1,  ///< failed but closed: its two faces share both end points
    boundary = 2             ///< open, or on the boundary from the start
};

/// A mesh whose edges fail and open: the state machine of the paper's appendix B, without physics. Two
/// corners of one original vertex share a vertex if and only if they are connected around it across interior
/// edges only. A failed edge is open if and only if its two sides have different vertices at one end.
class CrackMesh {
  public:
    explicit CrackMesh(Mesh mesh);

    const Mesh& mesh() const { return halfedges; }
    EdgeState state(Edge edge) const { return states[edge]; }
    /// The vertex of the unfractured mesh that `vertex` is, or is a copy of; edges likewise. An inserted
    /// element is its own original.
    Vertex original(Vertex vertex) const { return vertex_origin[vertex]; }
    Edge original(Edge edge) const { return edge_origin[edge]; }
    /// Whether the edge is on the boundary of the sheet, and not of a crack.
    bool is_outline(Edge edge) const { return outline[edge] != 0; }
    /// Whether an edge of the vertex has failed.
    bool is_cracked(Vertex vertex) const;
    /// Whether a crack ends at `vertex` inside the sheet: exactly one failed edge leads there.
    bool is_tip(Vertex vertex) const;

    /// The changes by the failure of some edges.
    struct Change {
        std::vector<int> boundary_vertices;  ///< for each failed edge: 0, 1 or 2 for the paper's B0, B1 or B2
        TopologyChange topology;
    };

    /// Makes `edges` fail at once and opens the mesh where possible. B0, B1 and B2 count the ends of each
    /// edge that lie on another failed or boundary edge, with all of `edges` failed and none of them open
    /// yet, so that nothing depends on their order. Throws Error naming the edge if one is not interior or is
    /// given twice.
    Change fail(std::span<const Edge> edges);

    /// Inserts an edge along a ray: see advance_edge(). Besides options.kept, vertices of cracks keep their
    /// place, and failed edges stay as lines. The new edge does not fail yet. Where it ends at a failed edge
    /// that is still closed, the latter opens there when the next edge fails.
    std::optional<AdvancedEdge> advance(Vertex tip, const Eigen::Vector3d& direction,
                                        const AdvanceOptions& options);

    void visit_state(StateVisitor& visit);

  private:
    int boundary_vertices(Edge edge) const;
    void follow(const TopologyChange& change);
    void share_origin(const WithParents<Edge>& inserted);

    Mesh halfedges;
    std::vector<EdgeState> states;
    std::vector<Vertex> vertex_origin;
    std::vector<Edge> edge_origin;
    std::vector<char> outline;    ///< [E]
    std::vector<Vertex> to_open;  ///< inserted on failed, closed edges; they split at the next failure
};

}  // namespace sherd
