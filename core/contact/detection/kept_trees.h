// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/detection/box_tree.h"
#include "core/contact/detection/collider_trees.h"

namespace sherd {

/// What a search for pairs keeps of its trees for the next one. No result depends on it.
struct KeptTrees {
    ColliderTrees colliders;
    BoxTree::Division vertices, triangles, edges;  ///< of the sheets
};

}  // namespace sherd
