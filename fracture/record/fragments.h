// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// The fragments of a mesh, with numbers that never change. When a fragment breaks, its largest part by area
/// keeps the number (of equally large parts, the part with the lowest face number), and the other parts get
/// new numbers in the order of their first faces.
class Fragments {
  public:
    /// areas: [F] m^2, of the faces at rest. The fragments of the unfractured mesh are numbered in the order
    /// of their first faces.
    Fragments(const Mesh& mesh, std::span<const double> areas);

    /// Assigns each inserted face to the fragment of its first parent, which covered most of it.
    void follow(const TopologyChange& change);

    /// Must be called when the mesh has opened. areas: [F] m^2, of the faces at rest.
    void update(const Mesh& mesh, std::span<const double> areas);

    std::span<const Index> of_face() const { return fragment_of_face; }  ///< [F] fragment of each face
    /// [fragments] number of the fragment from which each fragment separated; -1: it exists from the
    /// beginning.
    std::span<const Index> parents() const { return parent; }
    Index count() const { return static_cast<Index>(parent.size()); }  ///< number of all fragments so far

    void visit_state(StateVisitor& visit) {
        auto& [fragment_of_face, parent] = *this;
        visit(fragment_of_face, parent);
    }

  private:
    std::vector<Index> fragment_of_face, parent;
};

}  // namespace sherd
