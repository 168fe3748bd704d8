// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/triangle_edge.h"

#include <algorithm>

namespace sherd {

std::vector<TriangleEdge> boundary_triangle_edges(const Shell& shell, std::span<const char> selected) {
    std::vector<std::pair<Index, Index>> ends;
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 0; i < 3; ++i) ends.emplace_back(triangle.vertices[i], triangle.vertices[(i + 1) % 3]);
    std::sort(ends.begin(), ends.end());
    std::vector<TriangleEdge> sides;
    for (Index t = 0; t < static_cast<Index>(shell.triangles.size()); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto [from, to, opposite] = edge_and_apex(shell, {t, corner});
            // The neighbour, if there is one, has the side in the opposite direction.
            const bool boundary = !std::binary_search(ends.begin(), ends.end(), std::pair(to, from));
            if (boundary && selected[from] && selected[to]) sides.push_back({t, corner});
        }
    }
    return sides;
}

}  // namespace sherd
