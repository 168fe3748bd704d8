// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "fracture/vertex_pairs.h"
#include "meshops/topology_change.h"

namespace sherd {

/// The lips of cracks, from their opening until they are as far apart as the sheet is thick.
///
/// Vertices that a crack has split are twins: they coincide, and the barrier of SheetContact is infinite
/// there, so elements with one twin each do not collide. Until they are released LipContact keeps the two
/// edges of an opened crack apart; from then on SheetContact does, for good.
class Lips {
  public:
    /// Registers vertices that coincide from the beginning, as along a seam that is not joined, as twins
    /// without lips.
    void lie_together(Vertex a, Vertex b) { twins.add(a, b); }

    /// Must be called when the mesh was opened.
    void open(const TopologyChange& change);

    /// Must be called when faces have been cut. A vertex that was born on a lip lies on the other one, too:
    /// it is a twin of both ends of the edge there.
    void cut(const Mesh& mesh, const TopologyChange& change);

    /// Releases the twins whose elements are all farther apart at x [3, V] m than the sheet is thick;
    /// elements that still share a vertex or have other twins do not count. Returns whether there were any.
    bool release(const Mesh& mesh, const Shell& shell, const Positions& x);

    /// Adds to sheet.twins and sets sheet.lips. A lip resists overlap like a column of sheet whose
    /// cross-section is the lip's length times the thickness and whose length is the thickness: the force per
    /// metre of crack is Y / 2 times the overlap, on any mesh. Where a lip has been cut, its pieces face what
    /// they lie on: each end of the way that two have in common is held in front of the other one.
    void write(const Mesh& mesh, Shell& shell) const;

    bool has_twin(Vertex vertex) const { return twins.has(vertex); }

    void visit_state(StateVisitor& visit) {
        auto& [twins, edges] = *this;
        visit(twins, edges);
    }

  private:
    using Twins = std::array<Vertex, 2>;

    bool apart(const Mesh& mesh, const Shell& shell, const Positions& x, const Twins& pair) const;

    VertexPairs twins;
    std::vector<std::array<Edge, 2>> edges;  ///< opened edges: that of one face, and that of the other
};

}  // namespace sherd
