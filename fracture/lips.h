// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "core/shell/sheet.h"
#include "meshops/topology_change.h"

namespace sherd {

/// The lips of cracks from their opening until they are as far apart as the sheet is thick.
///
/// Vertices that a crack has split are twins: they lie at the same place, where the barrier of SheetContact
/// is infinite, so elements with one each do not see each other there. Until they are released LipContact
/// holds the two edges of an opened crack apart; from then on, for good, SheetContact does.
class Lips {
  public:
    /// Vertices that lie at the same place from the beginning, as along a seam that is not joined: twins
    /// without lips.
    void lie_together(Vertex a, Vertex b);

    /// To be called when the mesh has been opened.
    void open(const TopologyChange& change);

    /// Releases the twins whose elements are all farther apart at x [3, V] m than the sheet is thick, but for
    /// those that hang together elsewhere. Whether there were any.
    bool release(const Mesh& mesh, const Sheet& sheet, const Positions& x);

    /// Sets sheet.twins and sheet.lips. A lip resists overlap like a column of sheet of its own length and
    /// thickness in section and as long as it is thick: Y / 2 times overlap is the force on a metre of crack,
    /// on any mesh.
    void write(const Mesh& mesh, Sheet& sheet) const;

  private:
    using Twins = std::array<Vertex, 2>;

    bool are_twins(Vertex a, Vertex b) const;
    bool apart(const Mesh& mesh, const Sheet& sheet, const Positions& x, const Twins& pair) const;
    bool has_twin(Vertex vertex) const { return twins.count(vertex) > 0; }
    std::vector<Twins> pairs() const;  ///< each once, ascending

    std::map<Vertex, std::vector<Vertex>> twins;  ///< of each vertex that has any, both ways round
    std::vector<std::array<Edge, 2>> edges;       ///< opened ones: that of one face, and that of the other
};

}  // namespace sherd
