// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/vector.h"
#include "meshops/mesh.h"

namespace sherd {

/// The pieces of a mesh, with numbers that last: when a piece falls apart, its largest part by area keeps the
/// number (of equal ones that with the lowest face), and the others get new numbers, in the order of their
/// first faces.
class Fragments {
  public:
    /// areas: [F]. The pieces of the unbroken mesh are numbered in the order of their first faces.
    Fragments(const Mesh& mesh, std::span<const double> areas);

    /// To be called when the mesh has been opened.
    void update(const Mesh& mesh, std::span<const double> areas);

    std::span<const Index> of_face() const { return fragment_of_face; }  ///< [F]
    /// [fragments] the piece that each was a part of when it was born; -1: it was there from the beginning.
    std::span<const Index> parents() const { return parent; }
    Index count() const { return static_cast<Index>(parent.size()); }  ///< none ever ends

  private:
    std::vector<Index> fragment_of_face, parent;
};

}  // namespace sherd
