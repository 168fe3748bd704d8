// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_step.h"

#include <Eigen/LU>

namespace sherd {

ContactSurface surface_with(const Shell& shell, const RigidBody& body, std::size_t number, bool springs) {
    return ContactSurface(shell, {{body.surface.get(), body.young, body.friction, {}, number}}, false,
                          springs);
}

BodyStep::BodyStep(const Shell& shell, const RigidBody& body, const Vector3d& gravity,
                   const StepContext& step, const BodyOrigin& origin, const NearPairs* near,
                   std::size_t number, std::size_t obstacles, const BodySticks& elastic_slip)
    : shell(shell),
      body(body),
      near(near),
      number(number),
      lag(step.lag),
      origin(origin),
      gyration((body.inertia / body.mass).cwiseSqrt()),
      vertices(shell, body, obstacles + number) {
    Vector6d ahead = origin.pose + lag * origin.velocity;
    ahead.head<3>() += step.square() * gravity;
    predicted = columns(ahead);
    find_sliding(step.length, elastic_slip);
}

void BodyStep::find_sliding(double length, const BodySticks& elastic_slip) {
    const BodyPose start = pose(BodyColumns::Zero());
    vertices.begin(start.place, Matrix3d::Identity(), length, elastic_slip.vertices,
                   [&](const Vector3d& x) { return Vector3d(start.place.inverse() * x); });
    if (!near || body.friction == 0) return;
    const Positions local = in_frame_of(start, shell.position), space = start.place * local;
    for (const ContactPair& pair : near->active_pairs(local))
        sliding_pairs.push_back(sliding_pair(pair, sherd::columns(space, pair.vertices), body.friction,
                                             length, elastic_slip.pairs.slip_of({pair.kind, pair.vertices})));
}

Vector6d BodyStep::motion(const BodyColumns& q) const {
    Vector6d motion;
    motion << q.col(0), body.rotation * q.col(1).cwiseQuotient(gyration);
    return motion;
}

BodyColumns BodyStep::columns(const Vector6d& motion) const {
    BodyColumns q;
    q << motion.head<3>(), gyration.cwiseProduct(body.rotation.transpose() * motion.tail<3>());
    return q;
}

BodyPose BodyStep::pose(const BodyColumns& q) const {
    const Vector3d rotation = motion(q).tail<3>();
    const Matrix3d jacobian = rotation_jacobian(rotation) * body.rotation;
    BodyPose pose{Eigen::Isometry3d::Identity(), jacobian * gyration.cwiseInverse().asDiagonal()};
    pose.place.linear() = turned(rotation) * body.rotation;
    pose.place.translation() = body.centre + q.col(0);
    return pose;
}

Positions BodyStep::in_frame_of(const BodyPose& pose, const Positions& x) const {
    const Positions& points = body.surface->points;
    Positions all(3, points.cols() + x.cols());
    all << points, pose.place.inverse() * x;
    return all;
}

std::array<BodyForce::Point, 4> BodyStep::points_of(const std::array<Index, 4>& of_pair) const {
    std::array<BodyForce::Point, 4> points;
    for (int i = 0; i < 4; ++i) points[i] = {std::max(of_pair[i] - body.surface->size(), Index{-1}), number};
    return points;
}

PairPositions BodyStep::moved(const std::array<Index, 4>& of_pair, const Positions& x,
                              const BodyPose& here) const {
    const Positions& points = body.surface->points;
    const Eigen::Isometry3d before = body.pose();
    PairPositions way;
    for (int i = 0; i < 4; ++i) {
        const Index vertex = of_pair[i] - body.surface->size();
        if (vertex < 0)
            way.col(i) =
                here.place * Vector3d(points.col(of_pair[i])) - before * Vector3d(points.col(of_pair[i]));
        else
            way.col(i) = x.col(vertex) - shell.position.col(vertex);
    }
    return way;
}

BodySticks BodyStep::elastic_slip_after(const Positions& x, const BodyColumns& q) const {
    const BodyPose here = pose(q);
    BodySticks elastic_slip;
    vertices.store_slip(x, here.place, elastic_slip.vertices);
    for (const SlidingPair& pair : sliding_pairs)
        elastic_slip.pairs.keep(pair.key(), pair.elastic_slip_after(moved(pair.vertices, x, here)));
    elastic_slip.pairs.sort();
    return elastic_slip;
}

double BodyStep::free_fraction(const Positions& x, const BodyPose& here, const Positions& x_after,
                               const BodyPose& after) const {
    if (!near) return 1;
    const Positions start = in_frame_of(here, x);
    return near->safe_fraction(start, in_frame_of(after, x_after) - start);
}

bool BodyStep::has_straight_path(const Positions& x, const BodyColumns& q, double widths) const {
    const double width = widths * body.shape->bounds().sizes().minCoeff(), way = q.col(0).norm();
    if (!near || way <= width) return true;
    const BodyPose start = pose(BodyColumns::Zero());
    BodyPose end = start;
    end.place.translation() += q.col(0);
    return (1 - free_fraction(shell.position, start, x, end)) * way <= width;
}

bool BodyStep::passes(const Positions& x, const BodyColumns& q) const {
    return near && near->passes_in_parts(straight_parts(motion(q).tail<3>().norm()), [&](double share) {
        return in_frame_of(pose(share * q), shell.position + share * (x - shell.position));
    });
}

void BodyStep::add_near(const Positions& x, const BodyPose& here, std::set<Index>& found,
                        std::vector<std::pair<Index, Index>>& pairs) const {
    const double margin = ahead_of_contact * body.shape->bounds().diagonal().norm();
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        if (vertices.overlap(x, v, here.place, margin).depth > 0) found.insert(v);
    const std::size_t before = pairs.size();
    if (near) near->add_contacts(in_frame_of(here, x), true, pairs);
    for (const auto& [a, b] : std::span(pairs).subspan(before)) found.insert({a, b});
}

RigidBody BodyStep::moved(const BodyColumns& q) const {
    const BodyPose here = pose(q);
    const Vector3d rotation = motion(q).tail<3>();
    RigidBody result = body;
    result.centre += q.col(0);
    result.rotation = Eigen::Quaterniond(here.place.linear()).normalized().toRotationMatrix();
    result.velocity = (q.col(0) - origin.pose.head<3>()) / lag;
    // In the potential, a torque acts on the rotation vector multiplied by the transposed
    // rotation_jacobian(). The angular momentum must change by the torque itself, so that the shell gains the
    // angular momentum that the body loses.
    const Vector3d turned_by_torque =
        body.inertia_in_space() * (rotation - motion(predicted).tail<3>()) / lag;
    result.angular_momentum =
        origin.angular_momentum + rotation_jacobian(rotation).transpose().inverse() * turned_by_torque;
    return result;
}

Vector6d BodyStep::momentum_rate(const RigidBody& end) const {
    Vector6d rate;
    rate << body.mass * (end.velocity - origin.velocity.head<3>()),
        end.angular_momentum - origin.angular_momentum;
    return rate / lag;
}

Touch BodyStep::touch(const Positions& x, const BodyPose& here) const {
    Touch touch;
    vertices.add_touch(x, here.place, touch);
    std::set<const ColliderSurface*> itself;
    if (near) near->add_touched(in_frame_of(here, x), touch.vertices, itself);
    return touch;
}

}  // namespace sherd
