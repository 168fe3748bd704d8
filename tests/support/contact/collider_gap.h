// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/contact_colliders.h"
#include "tests/support/shell/plates.h"

namespace sherd::test {

/// Returns the shell and the collider at `time` as one surface of two sheets.
inline Shell together(const Shell& shell, const Obstacle& obstacle, double time) {
    const Positions collider = collider_positions({obstacle}, time);
    const Index first = static_cast<Index>(collider.cols());
    Shell both;
    resize_vertices(both, first + static_cast<Index>(shell.position.cols()));
    both.position << collider, shell.position;
    for (const auto& [a, b, c] : obstacle.surface->triangles)
        both.triangles.emplace_back().vertices = {a, b, c};
    for (const TriangleStencil& stencil : shell.triangles) {
        const auto [a, b, c] = stencil.vertices;
        both.triangles.emplace_back().vertices = {a + first, b + first, c + first};
    }
    for (Index v = first; v < static_cast<Index>(both.vertex_sheet.size()); ++v) both.vertex_sheet[v] = 1;
    return both;
}

/// Gap, m, between a sheet and an obstacle's surface at `time`; -1 if they intersect.
inline double gap(const Shell& shell, const Obstacle& obstacle, double time) {
    const Shell both = together(shell, obstacle, time);
    return intersections(both, both.position) > 0 ? -1 : smallest_distance(both, both.position);
}

}  // namespace sherd::test
