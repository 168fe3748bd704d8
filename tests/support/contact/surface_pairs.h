// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "core/contact/detection/contact_surface.h"

namespace sherd::test {

/// Kind and vertices of a contact pair.
using PairName = std::pair<PairKind, std::array<Index, 4>>;

inline double distance_at(const PairName& name, const Positions& x) {
    const PairPositions local = columns(x, name.second);
    return std::sqrt(squared_distance(closest_points(name.first, local), local));
}

/// Returns all pairs of the surface that are nearer at x than `share` times their activation distance, by
/// comparing all elements.
inline std::vector<PairName> pairs_nearer_than(double share, const ContactSurface& surface,
                                               const Positions& x) {
    std::vector<PairName> names;
    const auto look = [&](const PairName& name) {
        const auto& [kind, vertices] = name;
        if (!surface.apart(kind, vertices) &&
            distance_at(name, x) < share * surface.activation_distance(kind, vertices))
            names.push_back(name);
    };
    for (Index v = 0; v < (surface.sheets_meet() ? surface.vertices() : surface.collider_vertices()); ++v)
        for (const auto& [a, b, c] : surface.triangles()) look({PairKind::vertex_triangle, {v, a, b, c}});
    for (const auto& first : surface.edges())
        for (const auto& second : surface.edges())
            if (surface.sheets_meet() && first < second)
                look({PairKind::edge_edge, {first[0], first[1], second[0], second[1]}});
    for (const auto& [a, b] : surface.collider_edges())
        for (const auto& [c, d] : surface.edges()) look({PairKind::edge_edge, {a, b, c, d}});
    for (Index v = surface.collider_vertices(); v < surface.vertices(); ++v)
        for (const auto& [a, b, c] : surface.collider_triangles())
            look({PairKind::vertex_triangle, {v, a, b, c}});
    std::sort(names.begin(), names.end());
    return names;
}

inline std::vector<PairName> names_of(const std::vector<ContactPair>& pairs) {
    std::vector<PairName> names;
    for (const ContactPair& pair : pairs) names.emplace_back(pair.kind, pair.vertices);
    return names;
}

}  // namespace sherd::test
