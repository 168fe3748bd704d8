// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace sherd {

/// Corners of two triangles, m. The first `shared` corners of `a` and `b` are the same points.
struct TrianglePair {
    std::array<Eigen::Vector3d, 3> a, b;
    int shared = 0;
};

/// Whether two triangles intersect or touch elsewhere than at their shared corners, by exact predicates.
/// Returns false for triangles that share two corners: these could only meet elsewhere if one were folded
/// onto the other.
bool triangles_meet(const TrianglePair& pair);

}  // namespace sherd
