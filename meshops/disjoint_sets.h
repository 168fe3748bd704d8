// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace sherd {

/// Disjoint sets of the numbers from 0 to count - 1. The lowest number of a set represents it.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent(count) {
        std::iota(parent.begin(), parent.end(), std::size_t{0});
    }
    std::size_t find(std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a), b = find(b);
        parent[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent;
};

}  // namespace sherd
