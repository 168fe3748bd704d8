// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// Returns the inverse of each face's frame at x, [3, V] m: the matrix of two edges and the normal, [F]. The
/// result is zero for degenerate faces.
std::vector<Matrix3d> inverse_frames(const Shell& shell, const Positions& x);

/// Returns the rotation of the sheet around each vertex, [V], since the faces had these inverse frames: the
/// rotation in the polar decomposition of the mean deformation gradient of the vertex's faces, weighted with
/// their areas. The result is the identity for fixed and guided vertices, and where the decomposition fails.
std::vector<Matrix3d> vertex_rotations(const Shell& shell, const std::vector<Matrix3d>& inverse_frames,
                                       const Positions& x);

}  // namespace sherd
