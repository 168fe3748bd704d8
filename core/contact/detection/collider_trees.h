// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/detection/box_tree.h"
#include "core/contact/detection/contact_surface.h"
#include "core/contact/detection/neighbourhood.h"

namespace sherd {

/// Trees of bounding boxes around the elements of colliders, kept as long as a collider rests. Many colliders
/// have far more elements than the sheets, and do not move.
class ColliderTrees {
  public:
    /// The trees of one collider, in which element 0 is the first of that collider.
    struct Trees {
        BoxTree points, edges, triangles;
    };
    /// The trees around the paths of a collider's vertices on the motion of `within`, without any margin;
    /// null where the box around all paths does not meet `reach`. Trees are valid until the next call.
    const Trees* within_reach(const Box& reach, std::size_t collider, const ContactSurface& surface,
                              const Neighbourhood& within);

  private:
    struct Divisions {
        BoxTree::Division points, edges, triangles;
    };
    struct Cached {
        Positions from, to;  ///< m, of the collider's vertices at the beginning and the end of the motion
        Trees trees;
        Divisions divisions;
    };
    std::vector<Cached> cached;
};

}  // namespace sherd
