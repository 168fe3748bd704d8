// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>

#include "core/contact/geometry/collider_surface.h"
#include "core/contact/geometry/shape.h"

namespace sherd {

/// An obstacle, whose motion is prescribed, or a rigid body, which moves freely. Its pose is stored
/// elsewhere.
struct Collider {
    std::shared_ptr<const Shape> shape;
    /// Surface of the shape, in its frame. Without it only vertices of sheets collide with the collider,
    /// which is enough for a plane.
    std::shared_ptr<const ColliderSurface> surface = nullptr;
    double young = 3e10;  ///< Pa, of its material
    double friction = 0;  ///< Coulomb coefficient
};

/// The depth by which a point with a contact radius is inside a shape.
struct Overlap {
    double depth = 0;  ///< m, positive when they touch
    Vector3d normal = Vector3d::Zero();
    Matrix3d curvature = Matrix3d::Zero();  ///< 1/m, Hessian of the shape's distance
};

/// Overlap of the point `x` (in space) with contact radius `half` (m) and a shape whose pose is `pose`.
Overlap overlap(const Shape& shape, const Eigen::Isometry3d& pose, const Vector3d& x, double half);

/// Stiffness, N/m, of a column of sheet (footprint, m^2; thickness, m; young, Pa) in series with a collider's
/// material: footprint / thickness / (1 / Y_sheet + 1 / Y_collider).
inline double column_stiffness(double footprint, double thickness, double young, double collider_young) {
    return footprint / thickness / (1 / young + 1 / collider_young);
}

/// Coulomb coefficient of two colliders: the geometric mean of theirs, so that zero on one side means no
/// friction.
inline double friction_between(const Collider& one, const Collider& other) {
    return std::sqrt(one.friction * other.friction);
}

}  // namespace sherd
