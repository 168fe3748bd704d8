// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/corner_normals.h"
#include "meshops/write_mesh.h"

namespace sherd {

/// A sheet of which each point has one normal, pair of texture coordinates and colour, as glTF and graphics
/// cards want it.
struct SplitPoints {
    std::vector<std::size_t> points;                  ///< those of the sheet, one for each look that it has
    std::vector<std::array<std::size_t, 2>> corners;  ///< of each, a triangle and corner that has it; if any
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// Splits the points on seams of texture coordinates, where triangles have other colours, and where sides of
/// a solid meet its edges. Points keep their order, and all copies of one follow the others, in the order of
/// the triangles; a sheet without such places stays as it is.
SplitPoints split_points(const TriangleSheet& sheet);

/// Values of corners [T] at split points.
template <class Value>
std::vector<Value> at_points(const SplitPoints& split, const std::vector<std::array<Value, 3>>& of_corners) {
    std::vector<Value> values;
    for (const auto& [triangle, corner] : split.corners) values.push_back(of_corners[triangle][corner]);
    return values;
}

}  // namespace sherd
