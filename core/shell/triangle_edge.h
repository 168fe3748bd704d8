// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// The side of a triangle opposite `corner`. It refers to a triangle since triangles keep their number when a
/// crack splits vertices.
struct TriangleEdge {
    Index triangle = 0;
    int corner = 0;  ///< 0, 1 or 2
};

/// The side's vertices in the triangle's order: its two ends, then the opposite corner.
inline std::array<Index, 3> edge_and_apex(const Shell& shell, const TriangleEdge& side) {
    const std::array<Index, 3>& v = shell.triangles[side.triangle].vertices;
    return {v[(side.corner + 1) % 3], v[(side.corner + 2) % 3], v[side.corner]};
}

/// The sides on the boundary whose two ends are selected, ordered by triangle and corner. selected: [V]
/// flags.
std::vector<TriangleEdge> boundary_triangle_edges(const Shell& shell, std::span<const char> selected);

/// The sides that a side of a triangle has become after a change: one side, or, if it was split, two sides in
/// its direction; none if its edge was flipped.
std::vector<TriangleEdge> sides_after(const Shell& shell, const ShellChange& change,
                                      const TriangleEdge& side);

/// The two sides that each hinge joins, [H]: of T0, then of T1 (HingePositions).
std::vector<std::array<TriangleEdge, 2>> sides_of_hinges(const Shell& shell);
/// The two sides that each of `hinges` joins; all of them must be sides of the given triangles.
std::vector<std::array<TriangleEdge, 2>> sides_of_hinges(const Shell& shell, std::span<const Index> hinges,
                                                         std::span<const Index> triangles);

}  // namespace sherd
