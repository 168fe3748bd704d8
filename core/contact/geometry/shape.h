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

/// A collider, given by its signed distance in a frame of its own.
struct Shape {
    virtual ~Shape() = default;
    /// Signed distance, continuous, with its exact derivatives. Far outside, sampled shapes may return an
    /// infinite distance and no derivatives.
    virtual SurfaceDistance distance(const Vector3d& point) const = 0;
    /// A box that contains the collider; infinite where the collider is.
    virtual Eigen::AlignedBox3d bounds() const = 0;
};

}  // namespace sherd
