// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "fracture/start_overlap.h"
#include "fracture/vertex_pairs.h"
#include "meshops/topology_change.h"

namespace sherd {

/// Faces that cross or are too near at the start, until they are apart. As long as they cross, elements with
/// a vertex of each do not collide; where they are only too near, such elements push each other from the
/// distance on that they had. Other elements, and these once they are apart, collide as all do: so nothing is
/// flung apart, and nothing that was apart passes through anything.
class StartExemptions {
  public:
    void add(const Mesh& mesh, std::span<const StartOverlap> overlaps);

    /// Must be called when the mesh was changed: new vertices inherit from their parents.
    void follow(const TopologyChange& change);

    /// Ends those of vertices around which no faces cross any more and all elements are as far apart as
    /// others stay by themselves. Returns whether there were any.
    bool release(const Mesh& mesh, const Shell& shell);

    /// Adds to shell.twins and sets shell.near.
    void write(Shell& shell) const;

    bool has(Vertex vertex) const { return pairs.has(vertex); }
    std::size_t count() const { return pairs.all().size(); }

    void visit_state(StateVisitor& visit) {
        auto& [pairs] = *this;
        visit(pairs);
    }

  private:
    bool apart(const Mesh& mesh, const Shell& shell, const VertexPairs::Pair& pair) const;

    VertexPairs pairs;
};

}  // namespace sherd
