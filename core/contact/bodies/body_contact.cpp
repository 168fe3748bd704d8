// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_contact.h"

#include <algorithm>

namespace sherd {
namespace {

/// Limits, in widths of a body, on how far its predicted pose may be beyond a sheet, and beyond another
/// collider, which would push it out on the nearest side.
constexpr double most_widths = 8, most_widths_in_collider = 0.25;

}  // namespace

BodyContact::BodyContact(const Shell& shell, std::vector<RigidBody> bodies,
                         const std::vector<Obstacle>& obstacles, const Vector3d& gravity,
                         std::span<const char> crossed)
    : shell(shell),
      obstacles(obstacles),
      gravity(gravity),
      started(std::move(bodies)),
      finished(started),
      ended(started),
      surfaces(surface_pairs(started, obstacles, crossed)),
      sticks_with_shell(started.size()) {
    for (std::size_t b = 0; b < started.size(); ++b)
        pairs.push_back(started[b].surface ? std::make_unique<NearPairs>(with_surface(b)) : nullptr);
}

ContactSurface BodyContact::with_surface(std::size_t body) const {
    return surface_with(shell, started[body], obstacles.size() + body);
}

void BodyContact::begin(const StepContext& step) {
    started = finished;
    base.resize(0);
    make_steps(step);
    VectorXd ahead(base.size());
    for (std::size_t b = 0; b < steps.size(); ++b) ahead.segment<6>(6 * b) = steps[b].prediction();
    const Positions shell_ahead = shell.position + step.length * shell.velocity;
    is_blocked = !have_straight_paths(shell_ahead, ahead, most_widths, most_widths_in_collider);
    move_with_colliders();
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
                           obstacles.size() + b, sticks_with_shell[b]);
    if (base.size() == 0) base = VectorXd::Zero(static_cast<Eigen::Index>(6 * steps.size()));
    last.resize(3, 0);
    points = point_contacts(started, obstacles.size());
    sliding.clear();
    place_obstacles(step.begin);
    start_stored =
        potential(shell.position, VectorXd::Zero(static_cast<Eigen::Index>(6 * steps.size()))).stored;
    obstacle_starts = obstacle_places;
    place_obstacles(step.end());
    find_sliding(step);
    for (const auto& pair : surfaces) pair->begin(start_of(*pair), step.length);
}

void BodyContact::place_obstacles(double time) {
    obstacle_places.clear();
    for (const Obstacle& obstacle : obstacles) obstacle_places.push_back(obstacle.motion.at(time));
    for (const auto& pair : surfaces) pair->move_to(time);
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
        sliding.push_back({number, one, other, here.inverse() * contact_point,
                           sliding_point(there.inverse() * contact_point, at, turn, coefficient,
                                         body.point_stiffness(collider(other)), step.length,
                                         sticks_with_points.slip_of(number))});
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

template <class Add>
void BodyContact::each_surface_force(const std::vector<BodyPose>& at_q, Add add) const {
    for (const auto& pairs_of_two : surfaces_of_step()) {
        const SurfacePairs& two = *pairs_of_two;
        const PairPlaces places = places_of(two, at_q);
        two.each_active(places, [&](const ContactPair& pair, const PairPositions& at) {
            add(two, pair.vertices, at, PairPositions(PairPositions::Zero()), gradient(pair, at),
                hessian(pair, at, true), sherd::value(pair, at), true);
        });
        for (const SlidingPair& pair : two.sliding()) {
            const PairPositions way = two.moved(pair.vertices, places);
            add(two, pair.vertices, two.in_space(pair.vertices, places), way, pair.gradient(way),
                pair.hessian(way), pair.value(way), false);
        }
    }
}

void BodyContact::add_surface_pairs(const VectorXd& q, Potential& sum) const {
    const std::vector<BodyPose> at_q = poses(q);
    each_surface_force(at_q, [&](const SurfacePairs& two, const std::array<Index, 4>& vertices,
                                 const PairPositions& at, const PairPositions&, const PairPositions& force,
                                 const PairHessian& stiffness, double value, bool elastic) {
        (elastic ? sum.stored : sum.value) += value;
        Eigen::Matrix<double, 12, 12> motion = Eigen::Matrix<double, 12, 12>::Zero();
        for (int i = 0; i < 4; ++i) {
            const bool own = vertices[i] >= two.first();
            const std::size_t b = own ? two.body : two.other;
            if (!is_free(b)) continue;
            const Vector3d arm = at.col(i) - at_q[b].place.translation();
            motion.block<3, 6>(3 * i, own ? 0 : 6) = at_q[b].point_motion(arm);
            sum.turning[b] += force.col(i).norm() * arm.norm();
        }
        const Eigen::Matrix<double, 12, 1> by_q = motion.transpose() * force.reshaped();
        const Eigen::Matrix<double, 12, 12> twice = motion.transpose() * stiffness * motion;
        const std::array numbers{two.body, two.other};
        for (int i = 0; i < 2; ++i) {
            if (!is_free(numbers[i])) continue;
            sum.gradient.segment<6>(6 * numbers[i]) += by_q.segment<6>(6 * i);
            for (int j = 0; j < 2; ++j)
                if (is_free(numbers[j]))
                    sum.hessian.block<6, 6>(6 * numbers[i], 6 * numbers[j]) +=
                        twice.block<6, 6>(6 * i, 6 * j);
        }
    });
}

BodyContact::Potential BodyContact::potential(const Positions& x, const VectorXd& q) const {
    Potential sum;
    const auto size = static_cast<Eigen::Index>(6 * steps.size());
    sum.gradient = VectorXd::Zero(size);
    sum.hessian = Eigen::MatrixXd::Zero(size, size);
    sum.turning.assign(steps.size(), 0);
    add_point_contacts(q, sum);
    add_surface_pairs(q, sum);
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
    for (std::size_t b = 0; b < steps.size(); ++b)
        sticks_with_shell[b] = steps[b].elastic_slip_after(x, part(best, b));
    sticks_with_points.clear();
    for (const auto& [number, body, other, point, friction] : sliding)
        sticks_with_points.keep(number, friction.elastic_slip_after(at_end[body].place * point,
                                                                    at_end[other].place * friction.anchor));
    for (const auto& pair : surfaces) pair->finish(places_of(*pair, at_end));
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
    each_surface_force(poses(best),
                       [&](const SurfacePairs&, const std::array<Index, 4>&, const PairPositions&,
                           const PairPositions& moved, const PairPositions& force, const PairHessian&, double,
                           bool) { sum += force.cwiseProduct(moved).sum(); });
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

double BodyContact::work_of_deforming(const Positions& x) const {
    solve(x);
    const std::vector<BodyPose> at_end = poses(best);
    double sum = 0;
    each_surface_force(
        at_end, [&](const SurfacePairs& two, const std::array<Index, 4>& vertices, const PairPositions&,
                    const PairPositions&, const PairPositions& force, const PairHessian&, double, bool) {
            if (!two.other_deforms()) return;
            const PairPositions way = two.moved(vertices, places_of(two, at_end));
            for (int i = 0; i < 4; ++i)
                if (vertices[i] < two.first()) sum += force.col(i).dot(way.col(i));
        });
    return sum;
}

void BodyContact::add_reactions(const Positions& x, std::span<Reaction> of_obstacles) const {
    solve(x);
    each_point_force(best, [&](const std::vector<BodyPose>&, std::size_t, std::size_t other,
                               const PointForce& force, const Vector3d& at, const Vector3d&, bool) {
        if (!is_free(other)) of_obstacles[other - steps.size()].add(at, -force.gradient);
    });
    each_surface_force(poses(best), [&](const SurfacePairs& two, const std::array<Index, 4>& vertices,
                                        const PairPositions& at, const PairPositions&,
                                        const PairPositions& force, const PairHessian&, double, bool) {
        for (int i = 0; i < 4 && !is_free(two.other); ++i)
            if (vertices[i] >= two.first())
                of_obstacles[two.other - steps.size()].add(at.col(i), -force.col(i));
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
    const auto include = [&](std::size_t body, std::size_t other) {
        touch.bodies.insert(body);
        if (is_free(other))
            touch.bodies.insert(other);
        else
            touch.obstacles.insert(other - steps.size());
    };
    for (const PointContact& contact : points)
        if (overlap_of(contact, at_best_poses).depth > 0) include(contact.body, contact.other);
    for (const auto& pair : surfaces_of_step())
        if (pair->touch(places_of(*pair, at_best_poses))) include(pair->body, pair->other);
}

}  // namespace sherd
