// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/corner_normals.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Points of a sheet, copied so that each has a single normal, pair of texture coordinates and colour, as
/// glTF and graphics cards require.
struct SplitPoints {
    std::vector<std::size_t> points;  ///< the sheet's point that each split point is, or is a copy of
    /// For each split point, a triangle that has it as a corner, and the number of this corner.
    std::vector<std::array<std::size_t, 2>> corners;
    std::vector<std::array<std::int32_t, 3>> triangles;  ///< the sheet's triangles, of split points
};

/// Copies points on seams of texture coordinates, between triangles of different colours, and around each
/// quadrilateral of the rim or crack faces of a solid. Points keep their order, and the copies follow all of
/// them, in the order of the triangles. A sheet without such places is unchanged.
SplitPoints split_points(const TriangleSheet& sheet);

/// Returns the values of split points, from values of the triangles' corners [T].
template <class Value>
std::vector<Value> at_points(const SplitPoints& split, const std::vector<std::array<Value, 3>>& of_corners) {
    std::vector<Value> values;
    for (const auto& [triangle, corner] : split.corners) values.push_back(of_corners[triangle][corner]);
    return values;
}

}  // namespace sherd
