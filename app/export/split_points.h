// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/corner_normals.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// A sheet each point of which has a single normal, pair of texture coordinates and colour, as glTF and
/// graphics cards require.
struct SplitPoints {
    std::vector<std::size_t> points;                  ///< points of the sheet, repeated for each look
    std::vector<std::array<std::size_t, 2>> corners;  ///< triangle and corner of each point, if any
    std::vector<std::array<std::int32_t, 3>> triangles;
};

/// Splits the points on seams of texture coordinates, between triangles of different colours, and between
/// sides of a solid and its edges. Points keep their order, and all copies follow them, in the order of the
/// triangles; a sheet without such places is unchanged.
SplitPoints split_points(const TriangleSheet& sheet);

/// Gathers values of corners [T] at split points.
template <class Value>
std::vector<Value> at_points(const SplitPoints& split, const std::vector<std::array<Value, 3>>& of_corners) {
    std::vector<Value> values;
    for (const auto& [triangle, corner] : split.corners) values.push_back(of_corners[triangle][corner]);
    return values;
}

}  // namespace sherd
