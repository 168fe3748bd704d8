// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/contact/colliders/collider.h"
#include "core/state_visitor.h"

namespace sherd {

/// A collider that moves freely. The axes of its frame are its principal axes of inertia; the origin is its
/// centre of mass.
struct RigidBody : Collider {
    double mass = 1;                      ///< kg
    Vector3d inertia = Vector3d::Ones();  ///< kg m^2, about the principal axes
    /// contact_points: m, in the body's frame, points at which the body touches other colliders.
    /// contact_radius: m, radius of the sphere around each of them. contact_length: m, factor of
    /// point_stiffness().
    std::vector<Vector3d> contact_points;
    double contact_radius = 0, contact_length = 0;

    Vector3d centre = Vector3d::Zero();            ///< m, centre of mass
    Matrix3d rotation = Matrix3d::Identity();      ///< from its frame to space
    Vector3d velocity = Vector3d::Zero();          ///< m/s
    Vector3d angular_momentum = Vector3d::Zero();  ///< kg m^2/s, about the centre of mass, in space

    /// Visits the pose, the velocity and the angular momentum; the other members do not change in a run.
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
    /// Number of contact points that push at once, in an upper bound on contact frequencies: two for a ball
    /// and a box (for a box, one on each side of its centre), all points for a mesh with more than eight.
    double points_at_once() const {
        return contact_points.size() <= 8 ? 2 : static_cast<double>(contact_points.size());
    }
    /// Stiffness, N/m, of a contact point against another collider: contact_length times the modulus of the
    /// two materials in series.
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

/// Return a homogeneous sphere or box with the stiffness of steel, at rest, without surface. density: kg/m^3;
/// radius: m; size: m, from side to side.
RigidBody rigid_sphere(double radius, double density);
RigidBody rigid_box(const Vector3d& size, double density);
/// Returns a homogeneous solid of any shape with the stiffness of steel, at rest; the caller sets its shape
/// and surface. volume: m^3; inertia: m^5, moments of inertia about the principal axes for unit density;
/// density: kg/m^3. points: [3, P] m, points of its surface in its frame, which become the contact points. A
/// contact point is as stiff as a corner of a box of this volume. If there are more than 24 points, each is
/// softer, so that all together are as stiff as 24 such corners.
RigidBody rigid_solid(double volume, const Vector3d& inertia, const Positions& points, double density);

}  // namespace sherd
