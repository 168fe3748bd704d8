// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <vector>

#include "core/contact/geometry/distance.h"
#include "core/step_context.h"

namespace sherd {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix36d = Eigen::Matrix<double, 3, 6>;

/// Rotation by a rotation vector, rad.
Matrix3d turned(const Vector3d& rotation);
/// J with d(turned(r)) = cross_matrix(J dr) turned(r).
Matrix3d rotation_jacobian(const Vector3d& rotation);

/// Where a body is, and how its points move with q.
struct BodyPose {
    Eigen::Isometry3d place;  ///< from the body's frame to space
    Matrix3d jacobian;        ///< rotation_jacobian() of the step's rotation

    /// By q, of the body's point at `arm` (m, in space) from its centre.
    Matrix36d point_motion(const Vector3d& arm) const;
};

/// The incremental potential P(x, q) of a body in contact, with its derivatives.
struct BodyPotential {
    /// What a vertex of the sheet contributes.
    struct Push {
        Vector3d gradient = Vector3d::Zero();  ///< by x, N
        Matrix3d hessian = Matrix3d::Zero();   ///< by x twice, N/m
        Matrix36d mixed = Matrix36d::Zero();   ///< by x and q
    };
    double value = 0;   ///< J
    double stored = 0;  ///< J, elastic part of the value, in contacts
    Vector6d gradient = Vector6d::Zero();
    Matrix6d hessian = Matrix6d::Zero();  ///< Gauss-Newton: without the second derivative of rotations
    std::map<Index, Push> pushes;         ///< by vertex
    std::map<std::array<Index, 2>, Matrix3d> couplings;  ///< by two vertices, the greater one first, N/m

    /// A force between the vertex and the body's point at `arm`. gradient, hessian: by the vertex's position.
    void add_vertex(const BodyPose& pose, Index vertex, const Vector3d& gradient, const Matrix3d& hessian,
                    const Vector3d& arm);
    /// A force between four vertices, [3, 4]. Those below `first` are points of the body, in its frame
    /// `points`, the others vertices of the sheet, numbered from there. Derivatives are by positions in
    /// space.
    void add_element(const BodyPose& pose, const std::array<Index, 4>& vertices, Index first,
                     const Positions& points, const PairPositions& gradient, const PairHessian& hessian);
};

}  // namespace sherd
