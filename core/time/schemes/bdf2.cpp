// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/schemes/bdf2.h"

#include "core/contact/bodies/body_pose.h"
#include "core/shell/patch_momentum.h"

namespace sherd {
namespace {

Vector3d rotation_vector(const Matrix3d& rotation) {
    const Eigen::AngleAxisd turn(rotation);
    return turn.angle() * turn.axis();
}

}  // namespace

StepContext Bdf2::begin(const Shell& shell, const std::vector<RigidBody>& bodies, double time,
                        double length) {
    // v = ((1 + 2r) x - (1 + r)^2 x_0 + r^2 x_-1) / ((1 + r) h), where x_0 and x_-1 are the positions at the
    // beginning of this step and of the previous one, h is the length of this step, and r is its ratio to the
    // previous length.
    const double ratio = previous.length > 0 ? length / previous.length : 0;
    weights = {ratio * ratio / (1 + 2 * ratio), (1 + ratio) / (1 + 2 * ratio)};
    at_begin = {length, shell.position, shell.velocity, {}};
    StepContext step{time, length, weights.lag * length, {}, {}, {}};
    put_origins(shell, step);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const RigidBody& body = bodies[b];
        at_begin.bodies.push_back({body.centre, body.velocity, body.angular_momentum, body.rotation});
        step.bodies.push_back(origin_of(body, b, length));
    }
    return step;
}

void Bdf2::put_origins(const Shell& shell, StepContext& step) const {
    step.origin = shell.position;
    step.velocity_origin = shell.velocity;
    if (previous.length == 0) return;
    step.origin += weights.before_last * (shell.position - previous.position);
    step.velocity_origin += weights.before_last * (shell.velocity - previous.velocity);
}

BodyOrigin Bdf2::origin_of(const RigidBody& body, std::size_t number, double length) const {
    BodyOrigin origin;
    Vector3d velocity = body.velocity;
    origin.angular_momentum = body.angular_momentum;
    if (previous.length > 0) {
        const BodyState& then = previous.bodies[number];
        origin.pose << body.centre - then.centre, -rotation_vector(then.rotation * body.rotation.transpose());
        origin.pose *= weights.before_last;
        velocity += weights.before_last * (body.velocity - then.velocity);
        origin.angular_momentum += weights.before_last * (body.angular_momentum - then.angular_momentum);
    }
    // The spin is taken at the step's end: with the spin at its beginning the scheme would be of first order.
    RigidBody ahead = body;
    ahead.rotation = turned(length * body.spin()) * body.rotation;
    ahead.angular_momentum = origin.angular_momentum;
    origin.velocity << velocity, ahead.spin();
    return origin;
}

void Bdf2::topology_changed(const Shell& shell, const ShellChange& change, StepContext& step) {
    if (previous.length > 0) follow_in_motion(shell, change, previous.position, previous.velocity);
    at_begin.position = shell.position;
    at_begin.velocity = shell.velocity;
    put_origins(shell, step);
}

void Bdf2::finish(const StepContext& step, const Positions& x, Shell& shell) {
    std::swap(previous, at_begin);
    shell.velocity = step.velocity(x);
    shell.position = x;
}

}  // namespace sherd
