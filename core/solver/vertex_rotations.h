// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// Inverse frames of all faces at x [3, V] m: of two edges and the normal, [F].
std::vector<Matrix3d> inverse_frames(const Shell& shell, const Positions& x);

/// Rotation of the sheet around each vertex since its faces had these inverse frames: that of the mean
/// deformation gradient of the faces around it, weighted with their areas, [V]. It is the identity for
/// vertices that are held or guided, and where the gradient has no rotation.
std::vector<Matrix3d> vertex_rotations(const Shell& shell, const std::vector<Matrix3d>& inverse_frames,
                                       const Positions& x);

}  // namespace sherd
