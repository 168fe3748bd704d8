// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace sherd {

using Index = std::int32_t;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// One column a vertex: positions (m), velocities (m/s), forces (N).
using Positions = Eigen::Matrix3Xd;

/// The matrix of v x.
inline Matrix3d cross_matrix(const Vector3d& v) {
    Matrix3d matrix;
    matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return matrix;
}

}  // namespace sherd
