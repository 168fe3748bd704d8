// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/shape.h"

namespace sherd {

/// A half-space; the collider is on the side of the plane away from `normal`.
struct PlaneShape : Shape {
    Vector3d point = Vector3d::Zero();    ///< m
    Vector3d normal = Vector3d::UnitZ();  ///< unit length, points out of the collider

    PlaneShape() = default;
    PlaneShape(const Vector3d& point, const Vector3d& normal) : point(point), normal(normal) {}
    SurfaceDistance distance(const Vector3d& at) const override;
    Eigen::AlignedBox3d bounds() const override;
};

struct SphereShape : Shape {
    Vector3d centre = Vector3d::Zero();  ///< m
    double radius = 1;                   ///< m

    SphereShape() = default;
    SphereShape(const Vector3d& centre, double radius) : centre(centre), radius(radius) {}
    SurfaceDistance distance(const Vector3d& at) const override;
    Eigen::AlignedBox3d bounds() const override;
};

/// A box with its sides along the axes. Surfaces of constant distance outside the box are rounded at edges
/// and corners.
struct BoxShape : Shape {
    Vector3d centre = Vector3d::Zero();  ///< m
    Vector3d half = Vector3d::Ones();    ///< m, half of the sides' lengths

    BoxShape() = default;
    BoxShape(const Vector3d& centre, const Vector3d& half) : centre(centre), half(half) {}
    SurfaceDistance distance(const Vector3d& at) const override;
    Eigen::AlignedBox3d bounds() const override;
};

/// A cylinder with flat ends.
struct CylinderShape : Shape {
    Vector3d centre = Vector3d::Zero();  ///< m
    Vector3d axis = Vector3d::UnitZ();   ///< unit length
    double radius = 1, length = 1;       ///< m

    CylinderShape() = default;
    CylinderShape(const Vector3d& centre, const Vector3d& axis, double radius, double length)
        : centre(centre), axis(axis), radius(radius), length(length) {}
    SurfaceDistance distance(const Vector3d& at) const override;
    Eigen::AlignedBox3d bounds() const override;
};

/// Shape of a surface that has no inside because it is open or deforms. Sheets collide only with the
/// triangles of its ColliderSurface.
struct OpenSurface : Shape {
    SurfaceDistance distance(const Vector3d& at) const override;  ///< infinite
    Eigen::AlignedBox3d bounds() const override;                  ///< empty
};

}  // namespace sherd
