// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "fracture/breakable_sheet.h"

namespace sherd {

/// Two faces that no step can begin with.
struct StartOverlap {
    std::array<Index, 2> faces{};        ///< ascending
    bool crossing = false;               ///< they have points in common that they do not share as neighbours
    double distance = 0;                 ///< m, of their middle surfaces; 0 where they cross
    double needed = 0;                   ///< m, from which on they would push; 0 where they cross
    Vector3d normal = Vector3d::Zero();  ///< from the first to the second; 0 where they cross
};

/// All of them but for faces of one sheet that have vertices at the same place, as along a seam that is not
/// joined; those that cross first (by exact predicates), then those that SheetContact
/// would push apart from the beginning, by more than a hundredth of their distance; ascending by their faces,
/// each pair once.
std::vector<StartOverlap> start_overlaps(const BreakableSheet& sheet);

}  // namespace sherd
