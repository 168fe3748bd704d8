// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "fracture/shell/vertex_pairs.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// Crack faces, from their opening until their distance exceeds the sheet's thickness.
///
/// The copies of a vertex that a crack has split coincide at first, and at that distance the barrier of
/// SheetContact is infinite. Therefore two elements do not collide in SheetContact if each contains one
/// vertex of a coincident pair. Until the pair is released, CrackFaceContact keeps the two opposite edges of
/// the crack apart; from then on SheetContact keeps them apart.
class CrackFaces {
  public:
    /// Registers two coincident vertices without crack faces, such as those along a seam.
    void mark_coincident(Vertex a, Vertex b) { coincident.add(a, b); }

    /// Must be called when the mesh has opened.
    void open(const TopologyChange& change);

    /// Must be called when faces have been split. A vertex inserted on one crack face lies on an edge of the
    /// opposite crack face, too: it counts as coincident with the two ends of that edge.
    void cut(const Mesh& mesh, const TopologyChange& change);

    /// Releases each coincident pair if all elements with one of its vertices are farther apart at x ([3, V]
    /// m) than the sheet is thick. Elements that share a vertex or contain another coincident pair are not
    /// compared. Returns whether a pair has been released.
    bool release(const Mesh& mesh, const Shell& shell, const Positions& x);

    /// Appends the coincident pairs to shell.exempt_pairs, and sets shell.crack_faces. A crack face resists
    /// overlap like a column of sheet whose cross-section is the face's length times the thickness and whose
    /// length is the thickness: the force per metre of crack is Y / 2 times the overlap, on any mesh. Where
    /// an edge of a crack face has been split, each half is paired with the opposite edge. In each pair, the
    /// ends of one edge that lie along the other edge are kept in front of that edge.
    void write(const Mesh& mesh, Shell& shell) const;

    bool has_coincident(Vertex vertex) const { return coincident.has(vertex); }

    void visit_state(StateVisitor& visit) {
        auto& [coincident, edges] = *this;
        visit(coincident, edges);
    }

  private:
    using CoincidentPair = std::array<Vertex, 2>;

    bool apart(const Mesh& mesh, const Shell& shell, const Positions& x, const CoincidentPair& pair) const;

    VertexPairs coincident;
    std::vector<std::array<Edge, 2>> edges;  ///< pairs of opposite edges, one on each crack face
};

}  // namespace sherd
