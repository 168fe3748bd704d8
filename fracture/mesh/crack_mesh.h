// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/state_visitor.h"
#include "meshops/topology/advance/advance_edge.h"

namespace sherd {

/// State of an edge (paper, appendix B). Its number never decreases.
enum class EdgeState : std::uint8_t {
    interior = 0,            ///< has a hinge
    fractured_interior = 1,  ///< failed but closed: its two faces share both end points
    boundary = 2             ///< open, or on the sheet's boundary from the start
};

/// A mesh whose edges fail and open: the state machine of the paper's appendix B, without physics. Two
/// corners of faces at one original vertex share a vertex if and only if faces that adjoin at interior edges
/// connect them around it. A failed edge is open if and only if its two faces have different vertices at one
/// of its ends or at both.
class CrackMesh {
  public:
    explicit CrackMesh(Mesh mesh);

    const Mesh& mesh() const { return halfedges; }
    EdgeState state(Edge edge) const { return states[edge]; }
    /// The vertex from which cracks have copied `vertex`, directly or as a copy of a copy; the vertex itself,
    /// if it is no copy. Edges likewise; but of the two halves of a split edge only one keeps the original.
    Vertex original(Vertex vertex) const { return vertex_origin[vertex]; }
    Edge original(Edge edge) const { return edge_origin[edge]; }
    /// Whether the edge is on the boundary of the sheet, and not on a crack.
    bool is_outline(Edge edge) const { return outline[edge] != 0; }
    /// Whether an edge at the vertex has failed.
    bool is_cracked(Vertex vertex) const;
    /// Whether a crack ends at `vertex` inside the sheet: exactly one failed edge, both faces of the crack
    /// together, leads there.
    bool is_tip(Vertex vertex) const;

    /// Changes of the mesh by the failure of some edges.
    struct Change {
        std::vector<int> boundary_vertices;  ///< for each failed edge: 0, 1 or 2 for the paper's B0, B1 or B2
        TopologyChange topology;
    };

    /// Makes `edges` fail at once and opens the mesh where possible. Change::boundary_vertices is, for each
    /// edge, the number of its ends that lie on another failed or boundary edge. It is counted when all of
    /// `edges` have failed and none of them has opened, so that it does not depend on their order. Throws
    /// Error, which names the edge, if an edge is not interior or is given twice.
    Change fail(std::span<const Edge> edges);

    /// Makes an edge along the ray from `tip` in `direction`: see advance_edge(). Besides what options.kept
    /// keeps, vertices of cracks stay in their place, and failed and boundary edges remain as lines. The edge
    /// does not fail yet. If it ends on a failed edge that is still closed, that failed edge opens there when
    /// the next edges fail.
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
    std::vector<char> outline;  ///< [E] see is_outline()
    /// Vertices inserted on failed edges. If the edge is still closed, the vertex is split when the next
    /// edges fail.
    std::vector<Vertex> to_open;
};

}  // namespace sherd
