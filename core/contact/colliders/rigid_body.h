// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/contact/colliders/collider.h"
#include "core/state_visitor.h"

namespace sherd {

/// A collider that moves freely. The axes of its frame are its principal axes, the origin its centre of mass.
struct RigidBody : Collider {
    double mass = 1;                      ///< kg
    Vector3d inertia = Vector3d::Ones();  ///< kg m^2, about the principal axes
    /// The points at which it meets other colliders, in its frame, with the contact radius around them (m)
    /// and their stiffness per contact modulus (m).
    std::vector<Vector3d> contact_points;
    double contact_radius = 0, contact_length = 0;

    Vector3d centre = Vector3d::Zero();            ///< m, centre of mass
    Matrix3d rotation = Matrix3d::Identity();      ///< from its frame to space
    Vector3d velocity = Vector3d::Zero();          ///< m/s
    Vector3d angular_momentum = Vector3d::Zero();  ///< kg m^2/s, about the centre of mass

    /// Where it is and how it moves; all else is given.
    void visit_state(StateVisitor& visit) {
        static_assert(
            has_only<RigidBody, Collider, decltype(mass), decltype(inertia), decltype(contact_points),
                     decltype(contact_radius), decltype(contact_length), decltype(centre), decltype(rotation),
                     decltype(velocity), decltype(angular_momentum)>());
        visit(centre, rotation, velocity, angular_momentum);
    }

    Eigen::Isometry3d pose() const {  ///< from its frame to space
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.linear() = rotation;
        pose.translation() = centre;
        return pose;
    }
    /// How many of its contact points may push at once, on the safe side: of a box one on either side of its
    /// centre.
    double points_at_once() const {
        return contact_points.size() <= 8 ? 2 : static_cast<double>(contact_points.size());
    }
    /// Stiffness of a contact point against another collider, N/m.
    double point_stiffness(const Collider& other) const {
        return contact_length / (1 / young + 1 / other.young);
    }
    Matrix3d inertia_in_space() const { return rotation * inertia.asDiagonal() * rotation.transpose(); }
    Vector3d spin() const {  ///< angular velocity, rad/s
        return rotation * inertia.cwiseInverse().asDiagonal() * rotation.transpose() * angular_momentum;
    }
    double kinetic_energy() const {  ///< J
        return 0.5 * (mass * velocity.squaredNorm() + spin().dot(angular_momentum));
    }
};

/// The body of a homogeneous sphere or box, as stiff as steel, at rest. density: kg/m^3; radius, size: m.
RigidBody rigid_sphere(double radius, double density);
RigidBody rigid_box(const Vector3d& size, double density);
/// The same of any solid, without a shape and a surface, which the caller gives it. volume: m^3; inertia:
/// m^5, about the principal axes, for each unit of density; points: [3, P] m, of its surface, in its frame.
/// They are its contact points, and together as stiff as six boxes' corners of this volume.
RigidBody rigid_solid(double volume, const Vector3d& inertia, const Positions& points, double density);

}  // namespace sherd
