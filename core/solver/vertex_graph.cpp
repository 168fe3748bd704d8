// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/vertex_graph.h"

#include <numeric>

namespace sherd {

VertexGraph::VertexGraph(Index vertices, const std::vector<std::pair<Index, Index>>& pairs) {
    std::vector<std::size_t> named(vertices + 1, 0);
    for (const auto& [i, j] : pairs) {
        ++named[i + 1];
        ++named[j + 1];
    }
    std::partial_sum(named.begin(), named.end(), named.begin());
    std::vector<Index> all(named.back());
    std::vector<std::size_t> next(named.begin(), named.end() - 1);
    for (const auto& [i, j] : pairs) {
        all[next[i]++] = j;
        all[next[j]++] = i;
    }
    first.push_back(0);
    std::vector<Index> last(vertices, -1);  // vertex around which each was found last
    for (Index v = 0; v < vertices; ++v) {
        last[v] = v;
        for (std::size_t at = named[v]; at < named[v + 1]; ++at)
            if (std::exchange(last[all[at]], v) != v) neighbour.push_back(all[at]);
        first.push_back(neighbour.size());
    }
}

}  // namespace sherd
