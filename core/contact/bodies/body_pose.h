// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/step_context.h"

namespace sherd {

/// The two columns of a free body among the unknowns of a step, m: the displacement of its centre of mass,
/// and its rotation vector in the body's frame at the beginning of the step, with each coordinate multiplied
/// by the radius of gyration about its axis. In these coordinates the inertia is the body's mass for all six,
/// however the body is shaped and has turned.
using BodyColumns = Eigen::Matrix<double, 3, 2>;

/// The rotation matrix of a rotation vector, rad.
Matrix3d turned(const Vector3d& rotation);
/// The matrix J with d(turned(r)) = cross_matrix(J dr) turned(r).
Matrix3d rotation_jacobian(const Vector3d& rotation);

/// The pose of a collider, and how a body's points move with its columns.
struct BodyPose {
    Eigen::Isometry3d place;  ///< from the collider's frame to space
    Matrix3d jacobian;  ///< derivative, rad/m, of the rotation by the body's second column; obstacles: zero

    /// Derivative, by the second column, of the body's point at `x` (m, in space).
    Matrix3d turning(const Vector3d& x) const {
        return -cross_matrix(x - Vector3d(place.translation())) * jacobian;
    }
};

}  // namespace sherd
