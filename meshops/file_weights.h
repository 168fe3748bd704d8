// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace sherd {

/// A point in a triangle of the file that a mesh was remeshed from.
struct FileWeights {
    std::array<std::uint32_t, 3> vertices;  ///< numbers in the file, from 0
    Eigen::Vector3d weights;                ///< barycentric
};

namespace property {
inline constexpr const char* file_weights = "v:file_weights";  ///< FileWeights of each vertex, if remeshed
}  // namespace property

}  // namespace sherd
