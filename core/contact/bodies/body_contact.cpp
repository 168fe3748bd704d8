// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_contact.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace sherd {
namespace {

constexpr int most_iterations = 100, most_halvings = 40, most_hidden_halvings = 2;
constexpr double round_off_of_value = 1e-12;
constexpr double ahead_of_contact = 0.1;  // of a body's size: others that may soon touch it

bool is_ball(const RigidBody& body) {
    return body.feet.size() == 1;
}

double foot_stiffness(const RigidBody& body, const RigidBody& other) {
    return body.foot / (1 / body.young + 1 / other.young);
}

}  // namespace

BodyContact::BodyContact(const Sheet& sheet, std::vector<RigidBody> bodies,
                         const std::vector<Obstacle>& obstacles, const Vector3d& gravity)
    : sheet(sheet), obstacles(obstacles), gravity(gravity), started(std::move(bodies)), finished(started) {
    for (const RigidBody& body : started)
        pairs.push_back(body.surface ? std::make_unique<NearPairs>(surface_with(sheet, body)) : nullptr);
}

void BodyContact::begin(const StepContext& step) {
    started = finished;
    base = VectorXd::Zero(static_cast<Eigen::Index>(6 * started.size()));
    make_steps(step);
}

void BodyContact::topology_changed(const ShellChange&, const StepContext& step) {
    for (std::size_t b = 0; b < pairs.size(); ++b)
        if (pairs[b]) pairs[b]->surface_changed(surface_with(sheet, started[b]));
    make_steps(step);
}

void BodyContact::make_steps(const StepContext& step) {
    steps.clear();
    for (std::size_t b = 0; b < started.size(); ++b)
        steps.emplace_back(sheet, started[b], obstacles, gravity, step, step.bodies[b], pairs[b].get());
    meetings.clear();
    sliding.clear();
    last.resize(3, 0);
    find_meetings();
    find_sliding(step);
}

void BodyContact::find_meetings() {
    for (std::size_t a = 0; a < steps.size(); ++a)
        for (std::size_t b = 0; b < steps.size(); ++b) {
            const RigidBody &one = steps[a].start(), &other = steps[b].start();
            // A ball says all of what it meets, so that corners need not say it again, nor a second ball.
            const bool said = is_ball(other) && (!is_ball(one) || b < a);
            if (a == b || said) continue;
            for (const Vector3d& foot : one.feet)
                meetings.push_back({a, b, foot, foot_stiffness(one, other)});
        }
}

void BodyContact::find_sliding(const StepContext& step) {
    for (const Meeting& meeting : meetings) {
        const RigidBody &one = steps[meeting.one].start(), &other = steps[meeting.other].start();
        const double friction = friction_between(one.friction, other.friction);
        const BodyPose here = steps[meeting.one].pose(Vector6d::Zero()),
                       there = steps[meeting.other].pose(Vector6d::Zero());
        const Overlap at = overlap(*other.shape, there.place, here.place * meeting.foot, one.skin);
        if (friction == 0 || at.depth <= 0) continue;
        const Vector3d touching = here.place * meeting.foot - one.skin * at.normal;
        sliding.push_back({meeting.one,
                           meeting.other,
                           {here.place.inverse() * touching,
                            there.place.inverse() * touching,
                            Matrix3d::Identity() - at.normal * at.normal.transpose(),
                            {friction * meeting.stiffness * at.depth, smoothing_speed * step.lag}}});
    }
}

void BodyContact::add_between(const VectorXd& q, std::size_t one, std::size_t other, const Vector3d& arm,
                              const Vector3d& other_arm, const Vector3d& gradient, const Matrix3d& hessian,
                              Potential& sum) const {
    const Matrix36d here = steps[one].pose(part(q, one)).point_motion(arm),
                    there = -steps[other].pose(part(q, other)).point_motion(other_arm);
    sum.gradient.segment<6>(6 * one) += here.transpose() * gradient;
    sum.gradient.segment<6>(6 * other) += there.transpose() * gradient;
    sum.hessian.block<6, 6>(6 * one, 6 * one) += here.transpose() * hessian * here;
    sum.hessian.block<6, 6>(6 * other, 6 * other) += there.transpose() * hessian * there;
    const Matrix6d mixed = here.transpose() * hessian * there;
    sum.hessian.block<6, 6>(6 * one, 6 * other) += mixed;
    sum.hessian.block<6, 6>(6 * other, 6 * one) += mixed.transpose();
}

Overlap BodyContact::overlap_of(const Meeting& meeting, const VectorXd& q, double margin) const {
    const auto& [one, other, foot, stiffness] = meeting;
    const Eigen::Isometry3d here = steps[one].pose(part(q, one)).place,
                            there = steps[other].pose(part(q, other)).place;
    return overlap(*steps[other].start().shape, there, here * foot, steps[one].start().skin + margin);
}

void BodyContact::add_meetings(const VectorXd& q, Potential& sum) const {
    const auto place = [&](std::size_t body) { return steps[body].pose(part(q, body)).place; };
    for (const auto& [one, other, local, k] : meetings) {
        const Eigen::Isometry3d here = place(one), there = place(other);
        const Vector3d foot = here * local;
        const Overlap at = overlap(*steps[other].start().shape, there, foot, steps[one].start().skin);
        if (at.depth <= 0) continue;
        sum.stored += 0.5 * k * at.depth * at.depth;
        add_between(q, one, other, foot - here.translation(), foot - there.translation(),
                    -k * at.depth * at.normal, k * at.normal * at.normal.transpose(), sum);
    }
    for (const auto& [one, other, foot] : sliding) {
        const Eigen::Isometry3d here = place(one), there = place(other);
        const Vector3d slip = foot.tangent * (here * foot.point - there * foot.other);
        sum.value += foot.friction.value(slip);
        add_between(q, one, other, here.linear() * foot.point, there.linear() * foot.other,
                    foot.friction.gradient(slip), foot.friction.hessian(slip, foot.tangent), sum);
    }
}

BodyContact::Potential BodyContact::potential(const Positions& x, const VectorXd& q) const {
    Potential sum;
    const auto size = static_cast<Eigen::Index>(6 * steps.size());
    sum.gradient = VectorXd::Zero(size);
    sum.hessian = Eigen::MatrixXd::Zero(size, size);
    add_meetings(q, sum);
    sum.value += sum.stored;
    for (std::size_t b = 0; b < steps.size(); ++b) {
        sum.bodies.push_back(steps[b].potential(x, part(q, b)));
        const BodyPotential& own = sum.bodies.back();
        sum.value += own.value;
        sum.stored += own.stored;
        sum.gradient.segment<6>(6 * b) += own.gradient;
        sum.hessian.block<6, 6>(6 * b, 6 * b) += own.hessian;
    }
    return sum;
}

std::vector<std::size_t> BodyContact::groups(const VectorXd& q, bool ahead) const {
    std::vector<std::size_t> group(steps.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto join = [&](std::size_t one, std::size_t other) {
        const auto [kept, gone] = std::minmax(group[one], group[other]);
        std::replace(group.begin(), group.end(), std::size_t{gone}, std::size_t{kept});
    };
    for (const Meeting& meeting : meetings) {
        const double size = steps[meeting.other].start().shape->bounds().diagonal().norm();
        if (overlap_of(meeting, q, ahead ? ahead_of_contact * size : 0).depth > 0)
            join(meeting.one, meeting.other);
    }
    for (const SlidingMeeting& meeting : sliding) join(meeting.one, meeting.other);
    return group;
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

bool BodyContact::improve(const Positions& x) const {
    VectorXd direction = -at_best.hessian.ldlt().solve(at_best.gradient);
    const double slope = direction.dot(at_best.gradient);
    for (int halving = 0; halving < most_halvings; ++halving, direction /= 2) {
        if (best + direction == best) return false;
        if (const double fraction = free_way(x, best, best + direction); fraction < 1) {
            // A pose on the way is not on the line between the positions, so it has a way of its own.
            direction *= 2 * 0.9 * fraction;
            continue;
        }
        Potential trial = potential(x, best + direction);
        const double change = trial.value - at_best.value;
        // Where round-off hides the decrease, a step after which the slope is flatter is good, too.
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

double BodyContact::value(const Positions& x) const {
    return solve(x).value;
}

void BodyContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (const BodyPotential& body : solve(x).bodies)
        for (const auto& [vertex, push] : body.pushes) gradient.col(vertex) += push.gradient;
}

void BodyContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    const Potential& here = solve(x);
    const Eigen::MatrixXd inverse = here.hessian.inverse();
    const std::vector<std::size_t> group = groups(best, false);
    for (std::size_t one = 0; one < steps.size(); ++one) {
        for (std::size_t other = 0; other < steps.size(); ++other) {
            if (group[one] != group[other]) continue;
            const Matrix6d block = inverse.block<6, 6>(6 * one, 6 * other);
            for (const auto& [a, push] : here.bodies[one].pushes) {
                const Matrix36d eliminated = push.mixed * block;
                for (const auto& [b, against] : here.bodies[other].pushes) {
                    if (b > a) break;
                    const Matrix3d part = -eliminated * against.mixed.transpose();
                    if (a != b)
                        hessian.add(a, b, part);
                    else
                        hessian.add(a, a, 0.5 * (part + part.transpose()));
                }
            }
        }
        for (const auto& [vertex, push] : here.bodies[one].pushes) hessian.add(vertex, vertex, push.hessian);
        for (const auto& [vertices, part] : here.bodies[one].couplings)
            hessian.add(vertices[0], vertices[1], part);
    }
}

void BodyContact::add_contacts(const Positions& x, bool ahead,
                               std::vector<std::pair<Index, Index>>& pairs) const {
    const Potential& here = solve(x);
    // Bodies that press on each other pass on what the sheet does to one of them.
    const std::vector<std::size_t> group = groups(best, ahead);
    std::map<std::size_t, std::set<Index>> vertices;
    for (std::size_t b = 0; b < steps.size(); ++b) {
        std::set<Index>& all = vertices[group[b]];
        for (const auto& [vertex, push] : here.bodies[b].pushes) all.insert(vertex);
        if (ahead) steps[b].add_near_vertices(x, part(best, b), all);
    }
    for (const auto& [first, all] : vertices)
        for (const Index a : all)
            for (const Index b : all) {
                if (b == a) break;
                pairs.emplace_back(a, b);
            }
}

void BodyContact::finish(const Positions& x) {
    solve(x);
    for (std::size_t b = 0; b < steps.size(); ++b) finished[b] = steps[b].moved(part(best, b));
}

double BodyContact::stored_energy(const Positions& x) const {
    return solve(x).stored;
}

void BodyContact::add_touch(const Positions& x, Touch& touch) const {
    solve(x);
    for (std::size_t b = 0; b < steps.size(); ++b) {
        const Touch own = steps[b].touch(x, part(best, b));
        if (!own.vertices.empty() || !own.obstacles.empty()) touch.bodies.insert(b);
        touch.include(own);
    }
    for (const Meeting& meeting : meetings)
        if (overlap_of(meeting, best).depth > 0) touch.bodies.insert({meeting.one, meeting.other});
}

}  // namespace sherd
