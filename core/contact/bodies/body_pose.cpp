// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_pose.h"

#include <cmath>

namespace sherd {

Matrix3d turned(const Vector3d& rotation) {
    const double angle = rotation.norm();
    if (angle == 0) return Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

Matrix3d rotation_jacobian(const Vector3d& rotation) {
    const double angle = rotation.norm(), squared = angle * angle;
    const Matrix3d cross = cross_matrix(rotation);
    if (angle < 1e-4) return Matrix3d::Identity() + 0.5 * cross + cross * cross / 6;
    return Matrix3d::Identity() + (1 - std::cos(angle)) / squared * cross +
           (angle - std::sin(angle)) / (squared * angle) * cross * cross;
}

}  // namespace sherd
