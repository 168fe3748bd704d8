// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>

#include "core/contact/geometry/shape.h"
#include "core/contact/geometry/solid_surface.h"

namespace sherd {

/// What something rigid is that sheets meet, wherever it stands: an obstacle, whose motion is given, or a
/// rigid body, which moves freely.
struct Collider {
    std::shared_ptr<const Shape> shape;
    /// Of the shape, in its frame. Without it only vertices of sheets meet the collider: enough for a plane.
    std::shared_ptr<const SolidSurface> surface = nullptr;
    double young = 3e10;  ///< Pa, of what it is made of
    double friction = 0;  ///< Coulomb coefficient
};

/// How far a point with a skin is inside a shape.
struct Overlap {
    double depth = 0;  ///< m, positive when they touch
    Vector3d normal = Vector3d::Zero();
    Matrix3d curvature = Matrix3d::Zero();  ///< 1/m, Hessian of the shape's distance
};

/// `x` in space, with a skin of `half` (m) around it, against a shape that stands as `pose` says.
Overlap overlap(const Shape& shape, const Eigen::Isometry3d& pose, const Vector3d& x, double half);

/// Stiffness, N/m, of a column of sheet (footprint, m^2; thickness, m; young, Pa) against a material:
/// footprint / thickness / (1 / Y_sheet + 1 / Y_collider).
inline double column_stiffness(double footprint, double thickness, double young, double collider_young) {
    return footprint / thickness / (1 / young + 1 / collider_young);
}

/// Coulomb coefficient of two things that have one each: their geometric mean, so that what is smooth slides.
inline double friction_between(const Collider& one, const Collider& other) {
    return std::sqrt(one.friction * other.friction);
}

}  // namespace sherd
