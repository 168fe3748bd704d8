// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Faces of a mesh that intersect or touch a triangle surface, ascending, by exact predicates. points: [P] m;
/// triangles: numbers of points; those without area are ignored.
std::vector<Face> surface_crossings(const Mesh& mesh, std::span<const Eigen::Vector3d> points,
                                    std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace sherd
