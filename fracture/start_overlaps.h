// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fracture/breakable_shell.h"

namespace sherd {

/// Two faces that cross or are too close for a first step.
struct StartOverlap {
    std::array<Index, 2> faces{};        ///< ascending
    bool crossing = false;               ///< whether they intersect beyond shared vertices and edges
    double distance = 0;                 ///< m, of their middle surfaces; 0 if they cross
    double needed = 0;                   ///< m, their activation distance; 0 if they cross
    Vector3d normal = Vector3d::Zero();  ///< from the first to the second; 0 if they cross
};

/// Finds all such pairs, each once: first those that cross (by exact predicates), then those that are closer
/// than 0.99 of their activation distance in SheetContact, which would push them apart at the start. Both are
/// ascending by their faces. Faces of one sheet with coincident vertices, as along a seam that is not joined,
/// do not count.
std::vector<StartOverlap> start_overlaps(const BreakableShell& shell);

}  // namespace sherd
