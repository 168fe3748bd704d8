// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include "core/contact/bodies/body_pose.h"
#include "core/contact/colliders/rigid_body.h"
#include "tests/support/contact/obstacles.h"

namespace sherd::test {

/// Free box with a surface. size, from side to side, and centre: m; density: kg/m^3.
inline RigidBody solid_body(const Vector3d& size, const Vector3d& centre, double density = 2000) {
    RigidBody box = rigid_box(size, density);
    box.surface = box_surface(Vector3d::Zero(), 0.5 * size);
    box.centre = centre;
    box.friction = 0.3;
    return box;
}

/// Rotation by an eighth of a turn about `axis`, which turns a box that lies on a face onto an edge.
inline Matrix3d turn_about(const Vector3d& axis) {
    return Eigen::AngleAxisd(std::numbers::pi / 4, axis).toRotationMatrix();
}

/// Long box with an edge on top, which is along y at height zero and at `x`, m.
inline Obstacle roof(double x) {
    const double half = 0.01;
    Obstacle roof = solid_box(Vector3d::Zero(), Vector3d(half, 0.03, half), 3e10, 0.3);
    roof.motion.place.linear() = turn_about(Vector3d::UnitY());
    roof.motion.place.translation() = Vector3d(x, 0, -std::sqrt(2.0) * half);
    return roof;
}

/// Sum of the bodies' linear momenta, kg m/s, and of their angular momenta about the origin, kg m^2/s.
inline Vector6d momenta(const std::vector<RigidBody>& bodies) {
    Vector6d sum = Vector6d::Zero();
    for (const RigidBody& body : bodies) {
        sum.head<3>() += body.mass * body.velocity;
        sum.tail<3>() += body.mass * body.centre.cross(body.velocity) + body.angular_momentum;
    }
    return sum;
}

inline double kinetic(const std::vector<RigidBody>& bodies) {
    double sum = 0;
    for (const RigidBody& body : bodies) sum += body.kinetic_energy();
    return sum;
}

}  // namespace sherd::test
