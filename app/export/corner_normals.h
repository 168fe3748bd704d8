// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

using CornerNormals = std::vector<std::array<Eigen::Vector3d, 3>>;

/// Unit normals for shading at the corners of a sheet's triangles [T]: smooth over its sides, hard at their
/// edges, smooth along a rim that bends by less than some 30 degrees, and flat on broken sides. points:
/// positions of the sheet's points, m. A corner without area around it has z.
CornerNormals corner_normals(std::span<const Eigen::Vector3d> points, const TriangleSheet& sheet);

/// Unit normals at the corners of an obstacle's triangles; edges are hard where it bends by more than some 30
/// degrees.
CornerNormals creased_normals(const TriangleSheet& obstacle);

}  // namespace sherd
