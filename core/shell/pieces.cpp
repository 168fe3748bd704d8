// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/pieces.h"

#include <algorithm>
#include <numeric>

namespace sherd {
namespace {

/// Returns the lowest vertex that is known to be in a vertex's piece: the root of the vertex's tree of links,
/// which is shortened (union-find).
Index root(std::vector<Index>& link, Index vertex) {
    while (link[vertex] != vertex) vertex = link[vertex] = link[link[vertex]];
    return vertex;
}

void join(std::vector<Index>& link, Index one, Index other) {
    const Index a = root(link, one), b = root(link, other);
    link[std::max(a, b)] = std::min(a, b);
}

Pieces numbered(std::vector<Index>& link) {
    Pieces all;
    all.of_vertex.resize(link.size());
    for (Index v = 0; v < static_cast<Index>(link.size()); ++v)
        all.of_vertex[v] = link[v] == v ? all.count++ : all.of_vertex[root(link, v)];
    return all;
}

}  // namespace

Pieces pieces(const Shell& shell, const std::vector<std::pair<Index, Index>>& links, Index others) {
    std::vector<Index> link(shell.mass.size() + others);
    std::iota(link.begin(), link.end(), 0);
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 1; i < 3; ++i) join(link, triangle.vertices[0], triangle.vertices[i]);
    for (const auto& [one, other] : links) join(link, one, other);
    return numbered(link);
}

Pieces groups_among(const Shell& shell, const std::vector<char>& among) {
    std::vector<Index> link(among.size());
    std::iota(link.begin(), link.end(), 0);
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 0; i < 3; ++i) {
            const Index one = triangle.vertices[i], other = triangle.vertices[(i + 1) % 3];
            if (among[one] != 0 && among[other] != 0) join(link, one, other);
        }
    Pieces all = numbered(link);
    for (std::size_t v = 0; v < among.size(); ++v)
        if (among[v] == 0) all.of_vertex[v] = -1;
    return all;
}

}  // namespace sherd
