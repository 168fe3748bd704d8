// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/vector.h"

namespace sherd {

/// How far a point is from a surface, and how that changes with the point.
struct SurfaceDistance {
    double distance;    ///< m, negative inside
    Vector3d gradient;  ///< of unit length, or nearly so where distances are interpolated
    Matrix3d hessian;   ///< 1/m
};

/// A solid, in a frame of its own.
struct Shape {
    virtual ~Shape() = default;
    /// Exact derivatives of a distance that is continuous. Far outside, shapes that are sampled may give an
    /// infinite distance and no derivatives.
    virtual SurfaceDistance distance(const Vector3d& point) const = 0;
    /// Box that holds the solid; infinite where that is.
    virtual Eigen::AlignedBox3d bounds() const = 0;
};

}  // namespace sherd
