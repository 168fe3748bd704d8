// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// The connected pieces of a shell. Vertices are connected by faces and, if given, by further links.
struct Pieces {
    std::vector<Index> of_vertex;  ///< [V + others] number of each vertex's piece
    Index count = 0;
};

/// Finds the pieces, numbered from 0 in the order of their first vertices. links: further pairs of vertices
/// that are connected. others: number of further columns (as of bodies), numbered from V on, that `links` may
/// contain.
Pieces pieces(const Shell& shell, const std::vector<std::pair<Index, Index>>& links = {}, Index others = 0);

/// Finds the groups of the vertices v with among[v] != 0 that faces connect; the number of other vertices is
/// -1.
Pieces groups_among(const Shell& shell, const std::vector<char>& among);

}  // namespace sherd
