// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

namespace sherd {

/// Two triangles by their corners, m, of which the first `shared` are the same points.
struct TrianglePair {
    std::array<Eigen::Vector3d, 3> a, b;
    int shared = 0;
};

/// Whether two triangles have more in common than their shared corners, by exact predicates. Returns false
/// for triangles that share an edge: they would have to lie on each other.
bool triangles_meet(const TrianglePair& pair);

}  // namespace sherd
