// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sherd {

using Index = std::int32_t;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A column for each vertex: positions (m), velocities (m/s) or forces (N).
using Positions = Eigen::Matrix3Xd;

/// Returns the columns of `vertices`, [3, N].
template <std::size_t N>
Eigen::Matrix<double, 3, static_cast<int>(N)> columns(const Positions& all,
                                                      const std::array<Index, N>& vertices) {
    Eigen::Matrix<double, 3, static_cast<int>(N)> local;
    for (std::size_t i = 0; i < N; ++i) local.col(static_cast<Eigen::Index>(i)) = all.col(vertices[i]);
    return local;
}

/// The numbers from 0 to count - 1.
inline std::vector<Index> numbers_up_to(Index count) {
    std::vector<Index> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// The matrix that maps a vector y to the cross product of v and y.
inline Matrix3d cross_matrix(const Vector3d& v) {
    Matrix3d matrix;
    matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
    return matrix;
}

}  // namespace sherd
