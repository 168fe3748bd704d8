// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/contact_solids.h"
#include "tests/support/plates.h"

namespace sherd::test {

/// Sheet and solid as one surface of two bodies, as at `time`.
inline Sheet together(const Sheet& sheet, const Obstacle& obstacle, double time) {
    const Positions solid = solid_positions({obstacle}, time);
    const Index first = static_cast<Index>(solid.cols());
    Sheet both;
    resize_vertices(both, first + static_cast<Index>(sheet.position.cols()));
    both.position << solid, sheet.position;
    for (const auto& [a, b, c] : obstacle.surface->triangles)
        both.triangles.emplace_back().vertices = {a, b, c};
    for (const TriangleStencil& stencil : sheet.triangles) {
        const auto [a, b, c] = stencil.vertices;
        both.triangles.emplace_back().vertices = {a + first, b + first, c + first};
    }
    for (Index v = first; v < static_cast<Index>(both.body.size()); ++v) both.body[v] = 1;
    return both;
}

/// m, between a sheet and an obstacle's surface at `time`; negative if they cut each other.
inline double gap(const Sheet& sheet, const Obstacle& obstacle, double time) {
    const Sheet both = together(sheet, obstacle, time);
    return intersections(both, both.position) > 0 ? -1 : smallest_distance(both, both.position);
}

}  // namespace sherd::test
