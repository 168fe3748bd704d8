// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/detection/box_tree.h"
#include "core/contact/detection/contact_surface.h"
#include "core/contact/detection/neighbourhood.h"

namespace sherd {

/// Trees of boxes around the elements of solids, kept as long as a solid rests. Many solids have far more
/// elements than the sheets, and do not move.
class SolidTrees {
  public:
    /// Of one solid; element number 0 is its first.
    struct Trees {
        BoxTree points, edges, triangles;
    };
    /// Around what its vertices pass on the motion of `within`, without any margin. Valid until the next call
    /// for the same solid.
    const Trees& of(std::size_t solid, const ContactSurface& surface, const Neighbourhood& within);

  private:
    struct Kept {
        Positions from, to;  ///< m, of its vertices
        Trees trees;
    };
    std::vector<Kept> kept;
};

}  // namespace sherd
