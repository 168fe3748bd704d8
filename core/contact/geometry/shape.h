// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "core/vector.h"

namespace sherd {

/// Signed distance of a point from a surface, with its derivatives by the point.
struct SurfaceDistance {
    double distance;    ///< m, negative inside
    Vector3d gradient;  ///< unit length, or nearly so where distances are interpolated
    Matrix3d hessian;   ///< 1/m
};

/// A collider, given by the signed distance from its surface, in the collider's own frame.
struct Shape {
    virtual ~Shape() = default;
    /// Signed distance of `point` (m), continuous, with its exact derivatives. Far outside, sampled shapes
    /// may return an infinite distance without meaningful derivatives.
    virtual SurfaceDistance distance(const Vector3d& point) const = 0;
    /// A box, m, that contains the collider; infinite in directions in which the collider is infinite.
    virtual Eigen::AlignedBox3d bounds() const = 0;
};

}  // namespace sherd
