// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/collider.h"
#include "core/contact/friction/friction.h"
#include "core/energy.h"

namespace sherd {

/// The energy of a contact at a point, with derivatives by the point's position. The opposite force acts on
/// the collider that the point touches.
struct PointForce {
    double value;       ///< J
    Vector3d gradient;  ///< N
    Matrix3d hessian;   ///< N/m
};

/// The force of a spring that resists overlap; stiffness: N/m.
inline PointForce spring(const Overlap& at, double stiffness, Curvature curvature) {
    PointForce force{0.5 * stiffness * at.depth * at.depth, -(stiffness * at.depth * at.normal),
                     stiffness * (at.normal * at.normal.transpose())};
    if (curvature == Curvature::exact) force.hessian -= stiffness * at.depth * at.curvature;
    return force;
}

/// A point that touched a collider at the beginning of the step, with its friction in the step.
struct SlidingPoint {
    Vector3d anchor;  ///< m, position of the point if it sticks, in a frame that the owner chooses
    Vector3d normal;  ///< in space, of unit length
    Friction friction;

    /// The friction force on the point at x (m); anchor: in space.
    PointForce force(const Vector3d& x, const Vector3d& anchor) const {
        const Vector3d slip = along(x - anchor);
        const Matrix3d tangent = Matrix3d::Identity() - normal * normal.transpose();
        return {friction.value(slip), friction.gradient(slip), friction.hessian(slip, tangent)};
    }
    /// Elastic slip for the next step (Friction::elastic_slip_after()) when the point is at x (m); anchor: in
    /// space.
    Vector3d elastic_slip_after(const Vector3d& x, const Vector3d& anchor) const {
        return friction.elastic_slip_after(along(x - anchor));
    }

  private:
    Vector3d along(const Vector3d& way) const { return way - normal * normal.dot(way); }
};

/// Friction of a point that overlaps a collider, with the spring's force there as normal force. turn:
/// rotation applied to the normal, whose length sampled shapes give only near one, and to the elastic slip
/// `elastic_slip` (StickMemory); length: s, of the step.
inline SlidingPoint sliding_point(const Vector3d& anchor, const Overlap& at, const Matrix3d& turn,
                                  double coefficient, double stiffness, double length,
                                  const Vector3d& elastic_slip) {
    const double norm = at.normal.norm(), smoothing = smoothing_speed * length;
    const Vector3d normal = norm > 0 ? Vector3d(turn * at.normal / norm) : at.normal;
    const Vector3d turned = turn * elastic_slip;
    return {anchor,
            normal,
            {coefficient * stiffness * at.depth * norm, smoothing,
             smoothing * (turned - normal * normal.dot(turned))}};
}

}  // namespace sherd
