// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Neighbours of each vertex: the others with which it has a block.
class VertexGraph {
  public:
    VertexGraph() = default;
    /// pairs: in any order, repeated or not.
    VertexGraph(Index vertices, const std::vector<std::pair<Index, Index>>& pairs);
    std::span<const Index> around(Index vertex) const {
        return {neighbour.data() + first[vertex], first[vertex + 1] - first[vertex]};
    }
    Index size() const { return first.empty() ? 0 : static_cast<Index>(first.size()) - 1; }

  private:
    std::vector<std::size_t> first;
    std::vector<Index> neighbour;
};

}  // namespace sherd
