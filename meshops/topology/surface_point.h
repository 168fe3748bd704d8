// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "meshops/mesh.h"

namespace sherd {

/// A point of a surface, in one of its faces.
struct SurfacePoint {
    std::array<Vertex, 3> corners;  ///< vertices of the face, counterclockwise
    Eigen::Vector3d weights;        ///< barycentric: not negative, their sum is 1
};

/// Returns the position of the point in space, m.
Eigen::Vector3d position(const Mesh& mesh, const SurfacePoint& point);

/// Returns the barycentric weights of the point of a triangle that is nearest to `point` (m).
Eigen::Vector3d nearest_weights(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& point);

/// Returns the point of `face` that is nearest to `point` (m).
SurfacePoint nearest_point(const Mesh& mesh, Face face, const Eigen::Vector3d& point);

}  // namespace sherd
