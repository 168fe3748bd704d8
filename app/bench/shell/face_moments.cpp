// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/shell/face_moments.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/shell/shell.h"

namespace sherd {

double side_of(const Shell& shell, Index face) {
    const auto& [a, b, c] = shell.triangles[face].vertices;
    const Vector3d u = shell.rest.col(b) - shell.rest.col(a), v = shell.rest.col(c) - shell.rest.col(a);
    return u.cross(v).z() > 0 ? 1 : -1;
}

Vector2d middle_of(const Shell& shell, Index face) {
    Vector2d middle = Vector2d::Zero();
    for (const Index v : shell.triangles[face].vertices) middle += shell.rest.col(v).head<2>() / 3;
    return middle;
}

Eigen::Matrix2d face_moments(const Shell& shell, const FaceFields& fields, Index face, double thickness) {
    const Vector3d m = thickness * thickness / 12 * side_of(shell, face) *
                       (fields.stress_top.col(face) - fields.stress_bottom.col(face));
    const TrianglePositions rest = columns(shell.rest, shell.triangles[face].vertices);
    const Eigen::Matrix2d axes = frame_axes(rest).topRows<2>();
    return axes * (Eigen::Matrix2d() << m[0], m[2], m[2], m[1]).finished() * axes.transpose();
}

double moments_error(const Shell& shell, const FaceFields& fields, const PlateMoments& exact,
                     double thickness, double from, double to) {
    double error = 0, whole = 0;
    for (Index face = 0; face < static_cast<Index>(shell.triangles.size()); ++face) {
        const Vector2d middle = middle_of(shell, face);
        if (middle.norm() < from || middle.norm() > to) continue;
        const double area = shell.triangles[face].membrane.area;
        const Eigen::Matrix2d there = exact(middle);
        error += area * (face_moments(shell, fields, face, thickness) - there).squaredNorm();
        whole += area * there.squaredNorm();
    }
    return std::sqrt(error / whole);
}

}  // namespace sherd
