// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// The fragments of a mesh, with lasting numbers: when a fragment breaks, its largest part by area keeps the
/// number (of equal parts the one with the lowest face), and the others get new numbers in the order of their
/// first faces.
class Fragments {
  public:
    /// areas: [F] m^2. The fragments of the unfractured mesh are numbered in the order of their first faces.
    Fragments(const Mesh& mesh, std::span<const double> areas);

    /// Assigns inserted faces to the fragment of their main parent.
    void follow(const TopologyChange& change);

    /// Must be called when the mesh was opened.
    void update(const Mesh& mesh, std::span<const double> areas);

    std::span<const Index> of_face() const { return fragment_of_face; }  ///< [F] fragment of each face
    /// [fragments] the fragment from which each separated; -1 if it exists from the beginning.
    std::span<const Index> parents() const { return parent; }
    Index count() const { return static_cast<Index>(parent.size()); }  ///< number so far; no fragment ends

    void visit_state(StateVisitor& visit) {
        auto& [fragment_of_face, parent] = *this;
        visit(fragment_of_face, parent);
    }

  private:
    std::vector<Index> fragment_of_face, parent;
};

}  // namespace sherd
