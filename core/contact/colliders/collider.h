// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>

#include "core/contact/geometry/collider_surface.h"
#include "core/contact/geometry/shape.h"

namespace sherd {

/// An obstacle, whose motion is prescribed, or a rigid body, which moves freely. The pose is stored in
/// Obstacle and RigidBody.
struct Collider {
    std::shared_ptr<const Shape> shape;
    /// Surface of the shape, in the collider's frame. A collider without surface collides only with vertices
    /// of sheets and contact points of bodies, which is enough for a plane.
    std::shared_ptr<const ColliderSurface> surface = nullptr;
    double young = 3e10;  ///< Pa, Young's modulus of the material
    double friction = 0;  ///< Coulomb coefficient
};

/// The depth by which a point with a contact radius is inside a shape.
struct Overlap {
    double depth = 0;  ///< m, positive if the point's ball of the contact radius and the shape overlap
    Vector3d normal = Vector3d::Zero();     ///< gradient of the shape's distance, in space
    Matrix3d curvature = Matrix3d::Zero();  ///< 1/m, Hessian of the shape's distance, in space
};

/// Returns the overlap of a point at `x` (m, in space) that has the contact radius `half` (m) with a shape at
/// `pose`.
Overlap overlap(const Shape& shape, const Eigen::Isometry3d& pose, const Vector3d& x, double half);

/// Stiffness, N/m, of a column of sheet in series with a collider's material: footprint / thickness / (1 /
/// young + 1 / collider_young). footprint: m^2, cross-section of the column; thickness: m; young,
/// collider_young: Pa, Young's moduli of sheet and collider.
inline double column_stiffness(double footprint, double thickness, double young, double collider_young) {
    return footprint / thickness / (1 / young + 1 / collider_young);
}

/// Coulomb coefficient between two colliders: the geometric mean of their coefficients, so that there is no
/// friction if one of them is zero.
inline double friction_between(const Collider& one, const Collider& other) {
    return std::sqrt(one.friction * other.friction);
}

}  // namespace sherd
