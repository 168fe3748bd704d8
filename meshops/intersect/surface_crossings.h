// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Returns the faces of `mesh`, ascending, that intersect or touch the surface of `triangles`, by exact
/// predicates. points: [P] m; triangles: numbers of their corners in `points`. Triangles and faces without
/// area are ignored.
std::vector<Face> surface_crossings(const Mesh& mesh, std::span<const Eigen::Vector3d> points,
                                    std::span<const std::array<std::int32_t, 3>> triangles);

}  // namespace sherd
