// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

using CornerNormals = std::vector<std::array<Eigen::Vector3d, 3>>;

/// Unit normals for shading at the corners of the triangles [T] of a solid, by TriangleSheet::shading: smooth
/// over the two sides of the sheet, and flat on crack faces. On the rim, a quadrilateral of two triangles has
/// its flat normal at a point where that differs by more than some 30 degrees from the mean normal of the
/// rim, else the mean. A corner whose triangles have no area gets z. points: positions of the points, m.
CornerNormals corner_normals(std::span<const Eigen::Vector3d> points, const TriangleSheet& sheet);

/// Unit normals at the corners of an obstacle's triangles, with sharp edges as in creased().
CornerNormals creased_normals(const TriangleSheet& obstacle);

}  // namespace sherd
