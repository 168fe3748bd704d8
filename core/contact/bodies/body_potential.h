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

/// The rotation matrix of a rotation vector, rad.
Matrix3d turned(const Vector3d& rotation);
/// The matrix J with d(turned(r)) = cross_matrix(J dr) turned(r).
Matrix3d rotation_jacobian(const Vector3d& rotation);

/// The pose of a body, and how its points move with q.
struct BodyPose {
    Eigen::Isometry3d place;  ///< from the body's frame to space
    Matrix3d jacobian;        ///< rotation_jacobian() of the step's rotation

    /// Derivative by q of the body's point at `arm` (m, in space) from its centre of mass.
    Matrix36d point_motion(const Vector3d& arm) const;
};

/// The incremental potential P(x, q) of a body in contact, with its derivatives.
struct BodyPotential {
    /// The derivatives of P by the position x of one vertex of the shell.
    struct VertexTerms {
        Vector3d gradient = Vector3d::Zero();  ///< by x, N
        Matrix3d hessian = Matrix3d::Zero();   ///< by x twice, N/m
        Matrix36d mixed = Matrix36d::Zero();   ///< by x and q
    };
    double value = 0;   ///< J
    double stored = 0;  ///< J, elastic energy of the contacts, contained in value
    Vector6d gradient = Vector6d::Zero();
    Matrix6d hessian = Matrix6d::Zero();  ///< Gauss-Newton: without the second derivatives of rotations
    double turning = 0;  ///< N m, bound on what second derivatives of rotations add to the Hessian
    std::map<Index, VertexTerms> vertex_terms;           ///< by vertex number
    std::map<std::array<Index, 2>, Matrix3d> couplings;  ///< by two vertices, the greater number first, N/m

    /// Adds a force between a vertex and the body's point at `arm`. gradient, hessian: by the vertex's
    /// position.
    void add_vertex(const BodyPose& pose, Index vertex, const Vector3d& gradient, const Matrix3d& hessian,
                    const Vector3d& arm);
    /// Adds a force between four vertices, [3, 4]. Those with numbers below `first` are the body's points,
    /// given in its frame by `points`; the others are vertices of the shell, numbered from `first` on. The
    /// derivatives are by positions in space.
    void add_element(const BodyPose& pose, const std::array<Index, 4>& vertices, Index first,
                     const Positions& points, const PairPositions& gradient, const PairHessian& hessian);
};

}  // namespace sherd
