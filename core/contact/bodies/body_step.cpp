// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_step.h"

#include <Eigen/LU>

namespace sherd {
namespace {

/// A matrix of 4 x 4 blocks of vertices, rotated into other axes.
PairHessian turned_blocks(const PairHessian& matrix, const Matrix3d& rotation) {
    PairHessian result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            result.block<3, 3>(3 * i, 3 * j) =
                rotation * matrix.block<3, 3>(3 * i, 3 * j) * rotation.transpose();
    return result;
}

}  // namespace

ContactSurface surface_with(const Shell& shell, const RigidBody& body, std::size_t number, bool springs) {
    return ContactSurface(shell, {{body.surface.get(), body.young, body.friction, {}, number}}, false,
                          springs);
}

BodyStep::BodyStep(const Shell& shell, const RigidBody& body, const Vector3d& gravity,
                   const StepContext& step, const BodyOrigin& origin, const NearPairs* near,
                   std::size_t number, const BodySticks& elastic_slip)
    : shell(shell),
      body(body),
      near(near),
      lag(step.lag),
      origin(origin),
      inertia(body.inertia_in_space()),
      vertices(shell, body, number) {
    predicted = origin.pose + lag * origin.velocity;
    predicted.head<3>() += step.square() * gravity;
    find_sliding(step.length, elastic_slip);
}

void BodyStep::find_sliding(double length, const BodySticks& elastic_slip) {
    const BodyPose start = pose(Vector6d::Zero());
    vertices.begin(start.place, Matrix3d::Identity(), length, elastic_slip.vertices,
                   [&](const Vector3d& x) { return Vector3d(start.place.inverse() * x); });
    if (!near || body.friction == 0) return;
    const Positions local = in_frame_of(start, shell.position), space = start.place * local;
    for (const ContactPair& pair : near->active_pairs(local))
        sliding_pairs.push_back(sliding_pair(pair, columns(space, pair.vertices), body.friction, length,
                                             elastic_slip.pairs.slip_of({pair.kind, pair.vertices})));
}

BodyPose BodyStep::pose(const Vector6d& q) const {
    BodyPose pose{Eigen::Isometry3d::Identity(), rotation_jacobian(q.tail<3>())};
    pose.place.linear() = turned(q.tail<3>()) * body.rotation;
    pose.place.translation() = body.centre + q.head<3>();
    return pose;
}

Positions BodyStep::in_frame_of(const BodyPose& pose, const Positions& x) const {
    const Positions& points = body.surface->points;
    Positions all(3, points.cols() + x.cols());
    all << points, pose.place.inverse() * x;
    return all;
}

void BodyStep::add_inertia(const Vector6d& q, BodyPotential& sum) const {
    Matrix6d mass = Matrix6d::Zero();
    mass.topLeftCorner<3, 3>().diagonal().setConstant(body.mass / (lag * lag));
    mass.bottomRightCorner<3, 3>() = inertia / (lag * lag);
    const Vector6d away = q - predicted;
    sum.value += 0.5 * away.dot(mass * away);
    sum.gradient += mass * away;
    sum.hessian += mass;
}

void BodyStep::add_vertices(const Positions& x, const BodyPose& here, BodyPotential& sum) const {
    const auto add_force_on = [&](Index vertex, const PointForce& force, const Vector3d& at) {
        sum.add_vertex(here, vertex, force.gradient, force.hessian, at - here.place.translation());
    };
    vertices.add_springs(x, here.place, Curvature::convex, [&](Index vertex, const PointForce& force) {
        sum.stored += force.value;
        add_force_on(vertex, force, x.col(vertex));
    });
    vertices.add_friction(x, here.place, [&](Index vertex, const PointForce& force, const Vector3d& anchor) {
        sum.value += force.value;
        add_force_on(vertex, force, anchor);
    });
}

void BodyStep::add_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const {
    const Positions& points = body.surface->points;
    const Positions local = in_frame_of(here, x);
    const Matrix3d rotation = here.place.linear();
    for (const ContactPair& pair : near->active_pairs(local)) {
        const PairPositions at = columns(local, pair.vertices);
        sum.stored += sherd::value(pair, at);
        sum.add_element(here, pair.vertices, body.surface->size(), points, rotation * gradient(pair, at),
                        turned_blocks(hessian(pair, at, true), rotation));
    }
}

void BodyStep::add_sliding_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const {
    for (const SlidingPair& pair : sliding_pairs) {
        const PairPositions way = moved(pair, x, here);
        sum.value += pair.value(way);
        sum.add_element(here, pair.vertices, body.surface->size(), body.surface->points, pair.gradient(way),
                        pair.hessian(way));
    }
}

PairPositions BodyStep::moved(const SlidingPair& pair, const Positions& x, const BodyPose& here) const {
    const Positions& points = body.surface->points;
    const Eigen::Isometry3d before = pose(Vector6d::Zero()).place;
    PairPositions way;
    for (int i = 0; i < 4; ++i) {
        const Index vertex = pair.vertices[i];
        if (vertex < body.surface->size())
            way.col(i) = here.place * Vector3d(points.col(vertex)) - before * Vector3d(points.col(vertex));
        else
            way.col(i) =
                x.col(vertex - body.surface->size()) - shell.position.col(vertex - body.surface->size());
    }
    return way;
}

BodySticks BodyStep::elastic_slip_after(const Positions& x, const Vector6d& q) const {
    const BodyPose here = pose(q);
    BodySticks elastic_slip;
    vertices.store_slip(x, here.place, elastic_slip.vertices);
    for (const SlidingPair& pair : sliding_pairs)
        elastic_slip.pairs.keep(pair.key(), pair.elastic_slip_after(moved(pair, x, here)));
    elastic_slip.pairs.sort();
    return elastic_slip;
}

double BodyStep::friction_loss(const Positions& x, const Vector6d& q) const {
    const BodyPose here = pose(q);
    double sum = 0;
    vertices.add_friction(x, here.place, [&](Index vertex, const PointForce& force, const Vector3d& anchor) {
        sum += force.gradient.dot(x.col(vertex) - anchor);
    });
    for (const SlidingPair& pair : sliding_pairs) {
        const PairPositions way = moved(pair, x, here);
        sum += pair.gradient(way).cwiseProduct(way).sum();
    }
    return sum;
}

BodyPotential BodyStep::potential(const Positions& x, const Vector6d& q) const {
    const BodyPose here = pose(q);
    BodyPotential sum;
    add_inertia(q, sum);
    add_vertices(x, here, sum);
    if (near) {
        add_pairs(x, here, sum);
        add_sliding_pairs(x, here, sum);
    }
    sum.value += sum.stored;
    return sum;
}

double BodyStep::free_fraction(const Positions& x, const Vector6d& from, const Vector6d& to) const {
    if (!near) return 1;
    const BodyPose before = pose(from), after = pose(to);
    // In the body's frame, the straight motion takes the shell through images of itself that are not folded
    // over while the angle is less than pi. Whole turns count, since a motion that is not tested may be long.
    const double angle = (to - from).tail<3>().norm();
    if (angle > largest_turn) return 0.5 * largest_turn / angle;
    const Positions start = in_frame_of(before, x);
    return near->safe_fraction(start, in_frame_of(after, x) - start);
}

double BodyStep::free_motion(const Positions& x, const Positions& motion, const Vector6d& q) const {
    if (!near) return 1;
    const BodyPose here = pose(q);
    const Positions start = in_frame_of(here, x);
    return near->safe_fraction(start, in_frame_of(here, x + motion) - start);
}

bool BodyStep::has_straight_path(const Positions& x, const Vector6d& q, double widths) const {
    const double width = widths * body.shape->bounds().sizes().minCoeff(), way = q.head<3>().norm();
    if (!near || way <= width) return true;
    BodyPose start = pose(Vector6d::Zero()), end = start;
    end.place.translation() += q.head<3>();
    const Positions before = in_frame_of(start, shell.position);
    return (1 - near->safe_fraction(before, in_frame_of(end, x) - before)) * way <= width;
}

bool BodyStep::passes(const Positions& x, const Vector6d& q) const {
    return near && near->passes_in_parts(straight_parts(q.tail<3>().norm()), [&](double share) {
        return in_frame_of(pose(share * q), shell.position + share * (x - shell.position));
    });
}

void BodyStep::add_near_vertices(const Positions& x, const Vector6d& q, std::set<Index>& found) const {
    const BodyPose here = pose(q);
    const double margin = ahead_of_contact * body.shape->bounds().diagonal().norm();
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        if (vertices.overlap(x, v, here.place, margin).depth > 0) found.insert(v);
    std::vector<std::pair<Index, Index>> upcoming;
    if (near) near->add_contacts(in_frame_of(here, x), true, upcoming);
    for (const auto& [a, b] : upcoming) found.insert({a, b});
}

RigidBody BodyStep::moved(const Vector6d& q) const {
    const BodyPose here = pose(q);
    RigidBody result = body;
    result.centre += q.head<3>();
    result.rotation = Eigen::Quaterniond(here.place.linear()).normalized().toRotationMatrix();
    result.velocity = (q.head<3>() - origin.pose.head<3>()) / lag;
    // In P, torques act on the rotation vector through its Jacobian. The angular momentum takes them
    // directly: otherwise the shell would not gain what the body loses.
    const Vector3d turned_by_torque = inertia * (q.tail<3>() - predicted.tail<3>()) / lag;
    result.angular_momentum =
        origin.angular_momentum + here.jacobian.transpose().inverse() * turned_by_torque;
    return result;
}

Vector6d BodyStep::momentum_rate(const RigidBody& end) const {
    Vector6d rate;
    rate << body.mass * (end.velocity - origin.velocity.head<3>()),
        end.angular_momentum - origin.angular_momentum;
    return rate / lag;
}

Touch BodyStep::touch(const Positions& x, const Vector6d& q) const {
    Touch touch;
    const BodyPose here = pose(q);
    vertices.add_touch(x, here.place, touch);
    std::set<const ColliderSurface*> itself;
    if (near) near->add_touched(in_frame_of(here, x), touch.vertices, itself);
    return touch;
}

}  // namespace sherd
