// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/penalty/obstacle_contact.h"

namespace sherd {

void ObstacleContact::begin(const StepContext& step) {
    before = obstacle.motion.at(step.begin);
    pose = obstacle.motion.at(step.end());
    // The motion of an obstacle at rest must be exactly the identity; the product of its pose and the inverse
    // pose differs from it by round-off.
    const Eigen::Isometry3d moved =
        obstacle.moves() ? pose * before.inverse() : Eigen::Isometry3d::Identity();
    contact.begin(before, moved.linear(), step.length, elastic_slip,
                  [&](const Vector3d& x) { return Vector3d(moved * x); });
}

double ObstacleContact::stored_energy(const Positions& x, const Eigen::Isometry3d& there) const {
    double sum = 0;
    contact.add_springs(x, there, Curvature::convex,
                        [&](Index, const PointForce& force) { sum += force.value; });
    return sum;
}

double ObstacleContact::friction_loss(const Positions& x) const {
    double sum = 0;
    contact.add_friction(x, Eigen::Isometry3d::Identity(),
                         [&](Index vertex, const PointForce& force, const Vector3d& anchor) {
                             sum += force.gradient.dot(x.col(vertex) - anchor);
                         });
    return sum;
}

template <class Add>
void ObstacleContact::each_force(const Positions& x, Curvature curvature, Add add) const {
    contact.add_springs(x, pose, curvature, add);
    contact.add_friction(x, Eigen::Isometry3d::Identity(),
                         [&](Index vertex, const PointForce& force, const Vector3d&) { add(vertex, force); });
}

double ObstacleContact::value(const Positions& x) const {
    double sum = 0;
    each_force(x, Curvature::convex, [&](Index, const PointForce& force) { sum += force.value; });
    return sum;
}

void ObstacleContact::add_gradient(const Positions& x, Positions& gradient) const {
    each_force(x, Curvature::convex,
               [&](Index vertex, const PointForce& force) { gradient.col(vertex) += force.gradient; });
}

void ObstacleContact::add_reaction(const Positions& x, Reaction& reaction) const {
    each_force(x, Curvature::convex,
               [&](Index vertex, const PointForce& force) { reaction.add(x.col(vertex), -force.gradient); });
}

void ObstacleContact::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    each_force(x, curvature,
               [&](Index vertex, const PointForce& force) { hessian.add(vertex, vertex, force.hessian); });
}

}  // namespace sherd
