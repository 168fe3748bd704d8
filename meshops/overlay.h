// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

namespace sherd {

using PlaneTriangle = std::array<Eigen::Vector2d, 3>;  ///< counterclockwise

/// Area that two triangles have in common.
double common_area(const PlaneTriangle& a, const PlaneTriangle& b);

/// Which fraction of each old triangle each new one covers, where both cover the same polygon: [new, old],
/// the sum of each column is 1. Where round-off or curvature makes the two polygons differ, the fractions are
/// scaled to that sum.
Eigen::MatrixXd covered_fractions(std::span<const PlaneTriangle> now, std::span<const PlaneTriangle> old);

}  // namespace sherd
