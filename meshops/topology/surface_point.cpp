// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/surface_point.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "meshops/mesh_measures.h"

namespace sherd {

using Eigen::Vector3d;

Vector3d position(const Mesh& mesh, const SurfacePoint& point) {
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
        if (point.weights[i] != 0) sum += point.weights[i] * position(mesh, point.corners[i]);
    return sum;
}

Vector3d nearest_weights(const std::array<Vector3d, 3>& triangle, const Vector3d& point) {
    const Vector3d normal = triangle_normal(triangle);
    Vector3d weights;
    for (int i = 0; i < 3; ++i)
        weights[i] =
            (triangle[(i + 2) % 3] - triangle[(i + 1) % 3]).cross(point - triangle[(i + 1) % 3]).dot(normal);
    if (weights.minCoeff() >= 0) return weights / weights.sum();
    double least = std::numeric_limits<double>::infinity();
    Vector3d nearest = Vector3d::UnitX();
    for (int i = 0; i < 3; ++i) {
        const Vector3d side = triangle[(i + 1) % 3] - triangle[i];
        const double t = std::clamp((point - triangle[i]).dot(side) / side.squaredNorm(), 0.0, 1.0);
        const double distance = (triangle[i] + t * side - point).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest.setZero();
        nearest[i] = 1 - t;
        nearest[(i + 1) % 3] = t;
    }
    return nearest;
}

SurfacePoint nearest_point(const Mesh& mesh, Face face, const Vector3d& point) {
    const std::array<Vertex, 3> corners = face_corners(mesh, face);
    return {corners, nearest_weights(face_points(mesh, face), point)};
}

}  // namespace sherd
