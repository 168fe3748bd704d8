// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// The pieces of a shell that its faces, and perhaps other links, connect.
struct Pieces {
    std::vector<Index> of_vertex;  ///< [V + others]
    Index count = 0;
};

/// Finds the pieces, numbered from 0 in the order of their first vertices. links: further pairs of vertices
/// in one piece. others: number of further columns, counted from V on, that the links may name.
Pieces pieces(const Shell& shell, const std::vector<std::pair<Index, Index>>& links = {}, Index others = 0);

}  // namespace sherd
