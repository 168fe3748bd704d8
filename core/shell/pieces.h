// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// The pieces of a shell that its faces, and perhaps other links, connect.
struct Pieces {
    std::vector<Index> of_vertex;  ///< [V]
    Index count = 0;
};

/// Finds the pieces, numbered from 0 in the order of their first vertices. links: further pairs of vertices
/// in one piece.
Pieces pieces(const Shell& shell, const std::vector<std::pair<Index, Index>>& links = {});

}  // namespace sherd
