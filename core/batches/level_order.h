// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Level of a vertex in explicit steps: at level k its forces are evaluated 2^k times in a substep. An
/// element or a sum has the highest level of the vertices on which it depends.
using Level = std::uint8_t;

inline void raise(Level& level, Level to) {
    level = std::max(level, to);
}

/// Elements in descending order of their levels; elements of the same level keep their order. The elements
/// that depend on vertices of at least level k are the first count(k).
class LevelOrder {
  public:
    LevelOrder() = default;
    /// levels: of each element.
    explicit LevelOrder(const std::vector<Level>& levels) {
        const Level highest = levels.empty() ? Level{0} : *std::ranges::max_element(levels);
        counts.assign(highest + 1, 0);
        for (const Level level : levels)
            for (int k = 0; k <= level; ++k) ++counts[k];
        std::vector<Index> next(highest + 1, 0);  // place of the next element of each level
        for (int k = 0; k < highest; ++k) next[k] = counts[k + 1];
        order.resize(levels.size());
        for (Index i = 0; i < static_cast<Index>(levels.size()); ++i) order[next[levels[i]]++] = i;
    }

    Level highest() const { return static_cast<Level>(counts.size() - 1); }
    Index operator[](Index place) const { return order[place]; }
    /// Number of elements of at least level k.
    Index count(int k) const { return k < static_cast<int>(counts.size()) ? counts[k] : 0; }
    /// The elements of at least level k.
    std::span<const Index> of_level(int k) const { return std::span(order).first(count(k)); }

  private:
    std::vector<Index> order, counts{0};
};

}  // namespace sherd
