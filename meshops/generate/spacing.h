// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>

#include "meshops/error.h"

/// Spacing of the vertices of generated meshes.
namespace sherd::spacing {

inline constexpr int iterations = 20;  ///< enough for good angles, too few for long rows of vertices to form
inline constexpr double row_height = 0.93;    ///< edge lengths: side of a square with the area per vertex
inline constexpr double half_row = 0.45;      ///< edge lengths: free width beside a line of fixed vertices
inline constexpr double corner_degrees = 20;  ///< degrees: where a line turns by more, it has a vertex
/// Factor of the number of triangles: irregular triangles of a given mean edge length are slightly smaller
/// than equilateral ones.
inline constexpr double crowding = 1.025;

/// Returns the number of edges into which a line of `length` (m) is divided.
inline std::size_t pieces(double length, double edge_length) {
    return static_cast<std::size_t>(std::max(1L, std::lround(length / edge_length)));
}

inline std::string text(double number) {
    std::ostringstream stream;
    stream << number;
    return stream.str();
}

/// Throws Error where the edge length is larger than `largest` (m), the largest that `shape` allows.
inline void require_edge_length(double edge_length, double largest, const std::string& shape) {
    if (edge_length > largest)
        throw Error("cannot generate the mesh: edge_length " + text(edge_length) + " is too large for " +
                    shape + ", which takes at most " + text(largest));
}

}  // namespace sherd::spacing
