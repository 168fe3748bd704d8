// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/detection/box_tree.h"
#include "core/contact/detection/collider_trees.h"

namespace sherd {

/// Trees, and divisions of trees, that a search for pairs leaves to the next one. No result depends on them.
struct CachedTrees {
    ColliderTrees colliders;
    BoxTree::Division vertices, triangles, edges;  ///< divisions of the sheets' elements
};

}  // namespace sherd
