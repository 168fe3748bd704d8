// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_contact.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr int most_iterations = 100, most_halvings = 40, most_hidden_halvings = 2;
constexpr double round_off_of_value = 1e-12;
/// rad; a correction that turns a body farther knows nothing of what forces do to it on the way, as they turn
/// round what they push.
constexpr double large_turn = 0.1;
/// How many of its widths a body may be predicted to be beyond a sheet.
constexpr double most_widths = 8;
/// Share of the potential that another step of Newton's method may still take from where poses are the best.
constexpr double still_to_gain = 1e-9;
/// Of a body's size, and rad: of a body that weighs next to nothing the potential is all round-off.
constexpr double small_way = 1e-6;

}  // namespace

BodyContact::BodyContact(const Shell& shell, std::vector<RigidBody> bodies,
                         const std::vector<Obstacle>& obstacles, const Vector3d& gravity)
    : shell(shell),
      obstacles(obstacles),
      gravity(gravity),
      started(std::move(bodies)),
      finished(started),
      ended(started),
      held_by_shell(started.size()) {
    for (std::size_t b = 0; b < started.size(); ++b)
        pairs.push_back(started[b].surface ? std::make_unique<NearPairs>(with_surface(b)) : nullptr);
}

ContactSurface BodyContact::with_surface(std::size_t body) const {
    return surface_with(shell, started[body], obstacles.size() + body);
}

void BodyContact::begin(const StepContext& step) {
    started = finished;
    base = VectorXd::Zero(static_cast<Eigen::Index>(6 * started.size()));
    make_steps(step);
    const Positions ahead = shell.position + step.length * shell.velocity;
    is_blocked = std::ranges::any_of(steps, [&](const BodyStep& body) {
        return !body.has_straight_way(ahead, body.prediction(), most_widths);
    });
}

void BodyContact::topology_changed(const ShellChange& change, const StepContext& step) {
    for (std::size_t b = 0; b < pairs.size(); ++b)
        if (pairs[b]) pairs[b]->surface_changed(change, with_surface(b));
    make_steps(step);
}

void BodyContact::make_steps(const StepContext& step) {
    steps.clear();
    for (std::size_t b = 0; b < started.size(); ++b)
        steps.emplace_back(shell, started[b], gravity, step, step.bodies[b], pairs[b].get(),
                           obstacles.size() + b, held_by_shell[b]);
    last.resize(3, 0);
    points = point_contacts(started, obstacles.size());
    sliding.clear();
    place_obstacles(step.begin);
    start_stored =
        potential(shell.position, VectorXd::Zero(static_cast<Eigen::Index>(6 * steps.size()))).stored;
    place_obstacles(step.end());
    find_sliding(step);
}

void BodyContact::place_obstacles(double time) {
    obstacle_places.clear();
    for (const Obstacle& obstacle : obstacles) obstacle_places.push_back(obstacle.motion.at(time));
}

void BodyContact::find_sliding(const StepContext& step) {
    sliding.clear();
    const std::vector<BodyPose> start = poses(VectorXd::Zero(static_cast<Eigen::Index>(6 * steps.size())));
    for (std::size_t number = 0; number < points.size(); ++number) {
        const auto& [one, other, point] = points[number];
        const RigidBody& body = started[one];
        const double coefficient = friction_between(body, collider(other));
        if (coefficient == 0) continue;
        const bool given = !is_free(other);
        const Eigen::Isometry3d here = start[one].place,
                                there = given ? obstacles[other - steps.size()].motion.at(step.begin)
                                              : start[other].place;
        const Overlap at = overlap(*collider(other).shape, there, here * point, body.contact_radius);
        if (at.depth <= 0) continue;
        const Matrix3d turn =
            given ? Matrix3d(start[other].place.linear() * there.linear().transpose()) : Matrix3d::Identity();
        const Vector3d contact_point = here * point - body.contact_radius * at.normal;
        sliding.push_back(
            {number, one, other, here.inverse() * contact_point,
             sliding_point(there.inverse() * contact_point, at, turn, coefficient,
                           body.point_stiffness(collider(other)), step.length, held_by_points.of(number))});
    }
}

const Collider& BodyContact::collider(std::size_t number) const {
    if (is_free(number)) return started[number];
    return obstacles[number - steps.size()];
}

std::vector<BodyPose> BodyContact::poses(const VectorXd& q) const {
    std::vector<BodyPose> all;
    for (std::size_t body = 0; body < steps.size(); ++body) all.push_back(steps[body].pose(part(q, body)));
    for (const Eigen::Isometry3d& place : obstacle_places) all.push_back({place, Matrix3d::Zero()});
    return all;
}

void BodyContact::add_between(const std::vector<BodyPose>& poses, std::size_t body, std::size_t other,
                              const PointForce& force, const Vector3d& x, const Vector3d& anchor,
                              Potential& sum) const {
    const auto motion = [&](std::size_t b, const Vector3d& point) {
        return poses[b].point_motion(point - poses[b].place.translation());
    };
    const Matrix36d here = motion(body, x);
    const auto turn = [&](std::size_t b, const Vector3d& point) {
        sum.turning[b] += force.gradient.norm() * (point - poses[b].place.translation()).norm();
    };
    turn(body, x);
    sum.gradient.segment<6>(6 * body) += here.transpose() * force.gradient;
    sum.hessian.block<6, 6>(6 * body, 6 * body) += here.transpose() * force.hessian * here;
    if (!is_free(other)) return;
    turn(other, anchor);
    const Matrix36d there = -motion(other, anchor);
    sum.gradient.segment<6>(6 * other) += there.transpose() * force.gradient;
    sum.hessian.block<6, 6>(6 * other, 6 * other) += there.transpose() * force.hessian * there;
    const Matrix6d mixed = here.transpose() * force.hessian * there;
    sum.hessian.block<6, 6>(6 * body, 6 * other) += mixed;
    sum.hessian.block<6, 6>(6 * other, 6 * body) += mixed.transpose();
}

Overlap BodyContact::overlap_of(const PointContact& contact, const std::vector<BodyPose>& poses,
                                double margin) const {
    return overlap(*collider(contact.other).shape, poses[contact.other].place,
                   poses[contact.body].place * contact.point, started[contact.body].contact_radius + margin);
}

template <class Add>
void BodyContact::each_point_force(const VectorXd& q, Add add) const {
    const std::vector<BodyPose> at_q = poses(q);
    for (const PointContact& contact : points) {
        const Overlap at = overlap_of(contact, at_q);
        if (at.depth <= 0) continue;
        const Vector3d x = at_q[contact.body].place * contact.point;
        const double stiffness = started[contact.body].point_stiffness(collider(contact.other));
        add(at_q, contact.body, contact.other, spring(at, stiffness, Curvature::convex), x, x, true);
    }
    for (const auto& [number, body, other, point, friction] : sliding) {
        const Vector3d x = at_q[body].place * point, anchor = at_q[other].place * friction.anchor;
        add(at_q, body, other, friction.force(x, anchor), x, anchor, false);
    }
}

void BodyContact::add_point_contacts(const VectorXd& q, Potential& sum) const {
    each_point_force(q,
                     [&](const std::vector<BodyPose>& at_q, std::size_t body, std::size_t other,
                         const PointForce& force, const Vector3d& x, const Vector3d& anchor, bool elastic) {
                         (elastic ? sum.stored : sum.value) += force.value;
                         add_between(at_q, body, other, force, x, anchor, sum);
                     });
}

BodyContact::Potential BodyContact::potential(const Positions& x, const VectorXd& q) const {
    Potential sum;
    const auto size = static_cast<Eigen::Index>(6 * steps.size());
    sum.gradient = VectorXd::Zero(size);
    sum.hessian = Eigen::MatrixXd::Zero(size, size);
    sum.turning.assign(steps.size(), 0);
    add_point_contacts(q, sum);
    sum.value += sum.stored;
    for (std::size_t b = 0; b < steps.size(); ++b) {
        sum.bodies.push_back(steps[b].potential(x, part(q, b)));
        const BodyPotential& own = sum.bodies.back();
        sum.value += own.value;
        sum.stored += own.stored;
        sum.turning[b] += own.turning;
        sum.gradient.segment<6>(6 * b) += own.gradient;
        sum.hessian.block<6, 6>(6 * b, 6 * b) += own.hessian;
    }
    return sum;
}

double BodyContact::free_way(const Positions& x, const VectorXd& from, const VectorXd& to) const {
    double fraction = 1;
    for (std::size_t b = 0; b < steps.size(); ++b)
        fraction = std::min(fraction, steps[b].free_way(x, part(from, b), part(to, b)));
    return fraction;
}

void BodyContact::moved_to(const Positions& x) {
    solve(x);
    base = best;
}

double BodyContact::safe_fraction(const Positions& x, const Positions& motion) const {
    solve(x);
    double fraction = 1;
    for (std::size_t b = 0; b < steps.size(); ++b)
        fraction = std::min(fraction, steps[b].free_motion(x, motion, part(best, b)));
    return fraction;
}

VectorXd BodyContact::correction() const {
    VectorXd newton = -at_best.hessian.ldlt().solve(at_best.gradient);
    double most = 0;
    for (std::size_t b = 0; b < steps.size(); ++b) most = std::max(most, part(newton, b).tail<3>().norm());
    if (most <= large_turn) return newton;
    Eigen::MatrixXd stiffer = at_best.hessian;
    for (std::size_t b = 0; b < steps.size(); ++b)
        stiffer.diagonal().segment<3>(6 * b + 3).array() += at_best.turning[b];
    return -stiffer.ldlt().solve(at_best.gradient);
}

bool BodyContact::improve(const Positions& x) const {
    VectorXd direction = correction();
    const double slope = direction.dot(at_best.gradient);
    for (int halving = 0; halving < most_halvings; ++halving, direction /= 2) {
        if (best + direction == best) return false;
        if (const double fraction = free_way(x, best, best + direction); fraction < 1) {
            // The bodies rotate, so a pose part of the way is not on the line between the positions checked;
            // it needs a check of its own.
            direction *= 2 * 0.9 * fraction;
            continue;
        }
        Potential trial = potential(x, best + direction);
        const double change = trial.value - at_best.value;
        // Where round-off hides the decrease, a step that flattens the slope is accepted, too.
        const bool hidden = std::abs(change) <= round_off_of_value * std::abs(at_best.value);
        const bool flatter =
            std::abs(direction.dot(trial.gradient)) <= 0.5 * std::abs(direction.dot(at_best.gradient));
        if (hidden && !flatter && halving >= most_hidden_halvings) return false;
        if (hidden ? !flatter : change > 0) continue;
        best += direction;
        at_best = std::move(trial);
        return slope < 0;
    }
    return false;
}

const BodyContact::Potential& BodyContact::solve(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return at_best;
    best = base;
    at_best = potential(x, best);
    for (int i = 0; i < most_iterations && improve(x); ++i) {
    }
    last = x;
    return at_best;
}

bool BodyContact::is_small(const VectorXd& correction) const {
    for (std::size_t b = 0; b < steps.size(); ++b) {
        const Vector6d own = part(correction, b);
        const double size = started[b].shape->bounds().diagonal().norm();
        if (!(own.head<3>().norm() <= small_way * size && own.tail<3>().norm() <= small_way)) return false;
    }
    return true;
}

bool BodyContact::arrive(const Positions& x) const {
    const Potential& here = solve(x);
    const VectorXd correction = here.hessian.ldlt().solve(here.gradient);
    const bool is_best = here.gradient.dot(correction) <= still_to_gain * std::abs(here.value);
    if (!is_best && !is_small(correction)) return false;
    for (std::size_t b = 0; b < steps.size(); ++b)
        if (!steps[b].has_straight_way(x, part(best, b))) return false;
    return true;
}

double BodyContact::value(const Positions& x) const {
    return solve(x).value;
}

void BodyContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (const BodyPotential& body : solve(x).bodies)
        for (const auto& [vertex, terms] : body.vertex_terms) gradient.col(vertex) += terms.gradient;
}

void BodyContact::end_at(const Positions& x) {
    solve(x);
    for (std::size_t b = 0; b < steps.size(); ++b) ended[b] = steps[b].moved(part(best, b));
}

void BodyContact::finish(const Positions& x) {
    end_at(x);
    finished = ended;
    const std::vector<BodyPose> at_end = poses(best);
    for (std::size_t b = 0; b < steps.size(); ++b) held_by_shell[b] = steps[b].held_after(x, part(best, b));
    held_by_points.clear();
    for (const auto& [number, body, other, point, friction] : sliding)
        held_by_points.keep(
            number, friction.held_after(at_end[body].place * point, at_end[other].place * friction.anchor));
}

double BodyContact::stored_energy(const Positions& x) const {
    return solve(x).stored;
}

double BodyContact::friction_loss(const Positions& x) const {
    solve(x);
    double sum = 0;
    for (std::size_t b = 0; b < steps.size(); ++b) sum += steps[b].friction_loss(x, part(best, b));
    each_point_force(best,
                     [&](const std::vector<BodyPose>&, std::size_t, std::size_t, const PointForce& force,
                         const Vector3d& at, const Vector3d& anchor, bool elastic) {
                         if (!elastic) sum += force.gradient.dot(at - anchor);
                     });
    return sum;
}

double BodyContact::work_of_all() const {
    double sum = 0;
    for (std::size_t b = 0; b < steps.size(); ++b) {
        const Vector6d motion = part(best, b);
        sum += steps[b].momentum_rate(ended[b]).dot(motion);
    }
    return sum;
}

double BodyContact::contact_work() const {
    double weight = 0;
    for (std::size_t b = 0; b < steps.size(); ++b)
        weight += started[b].mass * gravity.dot(part(best, b).head<3>());
    return work_of_all() - weight;
}

double BodyContact::kinetic_change() const {
    double sum = 0;
    for (std::size_t b = 0; b < steps.size(); ++b)
        sum += ended[b].kinetic_energy() - started[b].kinetic_energy();
    return sum;
}

void BodyContact::add_reactions(const Positions& x, std::span<Reaction> of_obstacles) const {
    solve(x);
    each_point_force(best, [&](const std::vector<BodyPose>&, std::size_t, std::size_t other,
                               const PointForce& force, const Vector3d& at, const Vector3d&, bool) {
        if (!is_free(other)) of_obstacles[other - steps.size()].add(at, -force.gradient);
    });
}

void BodyContact::add_touch(const Positions& x, Touch& touch) const {
    solve(x);
    for (std::size_t b = 0; b < steps.size(); ++b) {
        const Touch own = steps[b].touch(x, part(best, b));
        if (!own.vertices.empty()) touch.bodies.insert(b);
        touch.include(own);
    }
    const std::vector<BodyPose> at_best_poses = poses(best);
    for (const PointContact& contact : points) {
        if (overlap_of(contact, at_best_poses).depth <= 0) continue;
        touch.bodies.insert(contact.body);
        if (is_free(contact.other))
            touch.bodies.insert(contact.other);
        else
            touch.obstacles.insert(contact.other - steps.size());
    }
}

}  // namespace sherd
