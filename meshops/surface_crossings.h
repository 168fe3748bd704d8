// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Faces of a mesh that have a point in common with a surface of triangles, ascending, by exact predicates;
/// that they only touch counts, too. points: [P] m; triangles: of points; those without area do not count.
std::vector<Face> surface_crossings(const Mesh& mesh, std::span<const Eigen::Vector3d> points,
                                    std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace sherd
