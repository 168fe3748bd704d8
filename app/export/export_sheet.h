// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fracture/record/snapshot.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

std::string fragment_name(std::size_t fragment);  ///< "fragment_007"
std::size_t fragment_count(const Snapshot& frame);

/// Returns all faces and vertices of a frame, in their order; the groups are the fragments.
TriangleSheet frame_sheet(const Snapshot& frame);

/// Returns the points that the triangles of a group use, ascending.
std::vector<std::size_t> group_points(const TriangleSheet& sheet, std::int32_t group);

/// Returns the triangles of one group with the points that they use, in their order.
TriangleSheet group_part(const TriangleSheet& sheet, std::int32_t group);

/// Returns the quantity `name` of each face [F]: `strain`, the largest magnitude of the strain of the hinges
/// at its edges (1/m); `speed`, the mean speed of its vertices (m/s); `stress`, the largest principal stress
/// at its two surfaces (Pa); `curvature`, the principal curvature of largest magnitude (1/m, signed); or
/// `fragment`, the number of its fragment. Throws Error (input) if the frame does not have the field.
std::vector<double> face_quality(const Snapshot& frame, const std::string& name);

/// Returns values[chosen[0]], values[chosen[1]], and so on.
template <class T>
std::vector<T> gathered(const std::vector<T>& values, const std::vector<std::size_t>& chosen) {
    std::vector<T> result;
    for (const std::size_t i : chosen) result.push_back(values[i]);
    return result;
}

}  // namespace sherd
