// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/triangle_edge.h"

#include <algorithm>
#include <tuple>
#include <utility>

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

std::vector<TriangleEdge> sides_after(const Shell& shell, const ShellChange& change,
                                      const TriangleEdge& side) {
    const ShellChange::ChangedFace* was = changed_face(change, side.triangle);
    if (was == nullptr) return {side};
    const auto find = [&](Index from, Index to) {
        std::vector<TriangleEdge> found;
        for (const IndexWithParents& face : change.reshaped)
            for (int corner = 0; corner < 3; ++corner)
                if (const auto [a, b, c] = edge_and_apex(shell, {face.element, corner}); a == from && b == to)
                    found.push_back({face.element, corner});
        return found;
    };
    const Index from = was->vertices[(side.corner + 1) % 3], to = was->vertices[(side.corner + 2) % 3];
    std::vector<TriangleEdge> after = find(from, to);
    if (!after.empty()) return after;
    for (const IndexWithParents& inserted : change.vertices) {
        const std::vector<TriangleEdge> first = find(from, inserted.element),
                                        second = find(inserted.element, to);
        if (!first.empty() && !second.empty()) return {first.front(), second.front()};
    }
    return {};
}

std::vector<std::array<TriangleEdge, 2>> sides_of_hinges(const Shell& shell) {
    return sides_of_hinges(shell, numbers_up_to(static_cast<Index>(shell.hinges.size())),
                           numbers_up_to(static_cast<Index>(shell.triangles.size())));
}

std::vector<std::array<TriangleEdge, 2>> sides_of_hinges(const Shell& shell, std::span<const Index> hinges,
                                                         std::span<const Index> triangles) {
    // Each side, with the vertices that it runs from and to. No two sides of triangles run from the same
    // vertex to the same vertex.
    std::vector<std::tuple<Index, Index, TriangleEdge>> sides;
    for (const Index t : triangles)
        for (int corner = 0; corner < 3; ++corner) {
            const auto [from, to, opposite] = edge_and_apex(shell, {t, corner});
            sides.emplace_back(from, to, TriangleEdge{t, corner});
        }
    const auto ends = [](const auto& side) { return std::pair(std::get<0>(side), std::get<1>(side)); };
    std::ranges::sort(sides, {}, ends);
    const auto find = [&](Index from, Index to) {
        return std::get<2>(*std::ranges::lower_bound(sides, std::pair(from, to), {}, ends));
    };
    std::vector<std::array<TriangleEdge, 2>> of_hinges;
    for (const Index hinge : hinges) {
        const std::array<Index, 4>& vertices = shell.hinges[hinge].vertices;
        of_hinges.push_back({find(vertices[0], vertices[1]), find(vertices[1], vertices[0])});
    }
    return of_hinges;
}

}  // namespace sherd
