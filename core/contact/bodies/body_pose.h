// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/step_context.h"

namespace sherd {

/// The two columns of a free body among the unknowns of a step, m: the displacement of its centre of mass,
/// and its rotation vector in the body's frame at the beginning of the step, with each coordinate multiplied
/// by the radius of gyration about its axis. In these coordinates the inertia of all six is the body's mass,
/// whatever its shape and rotation.
using BodyColumns = Eigen::Matrix<double, 3, 2>;

/// Returns the rotation matrix of a rotation vector (rad).
Matrix3d turned(const Vector3d& rotation);
/// Returns the matrix J for which d(turned(r)) = cross_matrix(J dr) turned(r), where r is the rotation vector
/// (rad).
Matrix3d rotation_jacobian(const Vector3d& rotation);

/// The pose of a collider, and the derivative of a body's rotation by its columns.
struct BodyPose {
    Eigen::Isometry3d place;  ///< transforms the collider's frame to space; translation in m
    /// Derivative, rad/m, of the body's rotation by its second column; zero for an obstacle.
    Matrix3d jacobian;

    /// Derivative of the position of the body's point at `x` (m, in space) by the body's second column.
    Matrix3d turning(const Vector3d& x) const {
        return -cross_matrix(x - Vector3d(place.translation())) * jacobian;
    }
};

}  // namespace sherd
