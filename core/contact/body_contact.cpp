// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/body_contact.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr int most_iterations = 100, most_halvings = 40;
constexpr double round_off_of_value = 1e-12;
constexpr double ahead_of_contact = 0.1;  // of the body's size: vertices that may soon touch

Matrix3d turned(const Vector3d& rotation) {
    const double angle = rotation.norm();
    if (angle == 0) return Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

/// d(turned(r)) = cross_matrix(J dr) turned(r).
Matrix3d rotation_jacobian(const Vector3d& rotation) {
    const double angle = rotation.norm(), squared = angle * angle;
    const Matrix3d cross = cross_matrix(rotation);
    if (angle < 1e-4) return Matrix3d::Identity() + 0.5 * cross + cross * cross / 6;
    return Matrix3d::Identity() + (1 - std::cos(angle)) / squared * cross +
           (angle - std::sin(angle)) / (squared * angle) * cross * cross;
}

/// How a point of the body at `arm` from its centre moves with q.
BodyContact::Matrix36d point_motion(const Vector3d& arm, const Matrix3d& jacobian) {
    BodyContact::Matrix36d motion;
    motion << Matrix3d::Identity(), -cross_matrix(arm) * jacobian;
    return motion;
}

}  // namespace

BodyContact::BodyContact(const Sheet& sheet, const RigidBody& body, const std::vector<Obstacle>& obstacles,
                         const Vector3d& gravity, double time, double step)
    : sheet(sheet),
      body(body),
      obstacles(obstacles),
      step(step),
      end(time + step),
      inertia(body.inertia_in_space()) {
    predicted << step * body.velocity + step * step * gravity, step * body.spin();
    best = predicted;
    if (body.friction == 0) return;
    const Eigen::Isometry3d start = pose(Vector6d::Zero());
    for (Index v = 0; v < static_cast<Index>(sheet.position.cols()); ++v) {
        const Vector3d x = sheet.position.col(v);
        const Overlap at = overlap(*body.shape, start, x, 0.5 * sheet.thickness[v]);
        if (at.depth > 0)
            sliding.push_back({v,
                               start.inverse() * x,
                               Matrix3d::Identity() - at.normal * at.normal.transpose(),
                               {body.friction * stiffness(v) * at.depth, smoothing_speed * step}});
    }
}

double BodyContact::stiffness(Eigen::Index vertex) const {
    return column_stiffness(sheet.footprint[vertex], sheet.thickness[vertex], sheet.young[vertex],
                            body.young);
}

Eigen::Isometry3d BodyContact::pose(const Vector6d& q) const {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = turned(q.tail<3>()) * body.rotation;
    pose.translation() = body.centre + q.head<3>();
    return pose;
}

void BodyContact::add_inertia(const Vector6d& q, Potential& sum) const {
    Matrix6d mass = Matrix6d::Zero();
    mass.topLeftCorner<3, 3>().diagonal().setConstant(body.mass / (step * step));
    mass.bottomRightCorner<3, 3>() = inertia / (step * step);
    const Vector6d away = q - predicted;
    sum.value += 0.5 * away.dot(mass * away);
    sum.gradient += mass * away;
    sum.hessian += mass;
}

void BodyContact::add_obstacles(const Vector6d& q, Potential& sum) const {
    const Eigen::Isometry3d here = pose(q);
    const Matrix3d jacobian = rotation_jacobian(q.tail<3>());
    for (const Obstacle& obstacle : obstacles) {
        const double stiffness = body.foot / (1 / body.young + 1 / obstacle.young);
        const Eigen::Isometry3d there = obstacle.motion.at(end);
        for (const Vector3d& foot : body.feet) {
            const Overlap at = overlap(*obstacle.shape, there, here * foot, body.skin);
            if (at.depth <= 0) continue;
            const Vector6d slope = point_motion(here.linear() * foot, jacobian).transpose() * at.normal;
            sum.stored += 0.5 * stiffness * at.depth * at.depth;
            sum.gradient -= stiffness * at.depth * slope;
            sum.hessian += stiffness * slope * slope.transpose();
        }
    }
}

void BodyContact::add_sheet(const Positions& x, const Vector6d& q, Potential& sum) const {
    const Eigen::Isometry3d here = pose(q);
    const Matrix3d jacobian = rotation_jacobian(q.tail<3>());
    const auto add = [&](Push& push, const Vector3d& gradient, const Matrix3d& hessian, const Vector3d& arm) {
        const Matrix36d relative = -point_motion(arm, jacobian);
        push.gradient += gradient;
        push.hessian += hessian;
        push.mixed += hessian * relative;
        sum.gradient += relative.transpose() * gradient;
        sum.hessian += relative.transpose() * hessian * relative;
    };
    auto slider = sliding.begin();
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        Push push{v};
        const Overlap at = overlap(*body.shape, here, x.col(v), 0.5 * sheet.thickness[v]);
        const bool slides = slider != sliding.end() && slider->vertex == v;
        if (at.depth > 0) {
            const double k = stiffness(v);
            sum.stored += 0.5 * k * at.depth * at.depth;
            add(push, -k * at.depth * at.normal, k * at.normal * at.normal.transpose(),
                x.col(v) - here.translation());
        }
        if (slides) {
            const Vector3d slip = slider->tangent * (x.col(v) - here * slider->foot);
            sum.value += slider->friction.value(slip);
            add(push, slider->friction.gradient(slip), slider->friction.hessian(slip, slider->tangent),
                here.linear() * slider->foot);
            ++slider;
        }
        if (slides || at.depth > 0) sum.pushes.push_back(push);
    }
}

BodyContact::Potential BodyContact::potential(const Positions& x, const Vector6d& q) const {
    Potential sum;
    add_inertia(q, sum);
    add_obstacles(q, sum);
    add_sheet(x, q, sum);
    sum.value += sum.stored;
    return sum;
}

bool BodyContact::improve(const Positions& x) const {
    Vector6d direction = -at_best.hessian.ldlt().solve(at_best.gradient);
    const double slope = direction.dot(at_best.gradient);
    for (int halving = 0; halving < most_halvings; ++halving, direction /= 2) {
        if (best + direction == best) return false;
        Potential trial = potential(x, best + direction);
        const double change = trial.value - at_best.value;
        // Where round-off hides the decrease, a step after which the slope is flatter is good, too.
        const bool hidden = std::abs(change) <= round_off_of_value * std::abs(at_best.value);
        const bool flatter =
            std::abs(direction.dot(trial.gradient)) <= 0.5 * std::abs(direction.dot(at_best.gradient));
        if (hidden ? !flatter : change > 0) continue;
        best += direction;
        at_best = std::move(trial);
        return slope < 0;
    }
    return false;
}

const BodyContact::Potential& BodyContact::solve(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return at_best;
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
    for (const Push& push : solve(x).pushes) gradient.col(push.vertex) += push.gradient;
}

void BodyContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    const Potential& here = solve(x);
    const Matrix6d inverse = here.hessian.inverse();
    for (const Push& a : here.pushes) {
        const Matrix36d eliminated = a.mixed * inverse;
        for (const Push& b : here.pushes) {
            if (b.vertex > a.vertex) break;
            Matrix3d block = -eliminated * b.mixed.transpose();
            if (a.vertex == b.vertex) block = (a.hessian + 0.5 * (block + block.transpose())).eval();
            hessian.add(a.vertex, b.vertex, block);
        }
    }
}

void BodyContact::add_contacts(const Positions& x, bool ahead,
                               std::vector<std::pair<Index, Index>>& pairs) const {
    std::vector<Index> vertices;
    for (const Push& push : solve(x).pushes) vertices.push_back(push.vertex);
    if (ahead) {
        const Eigen::Isometry3d here = pose(best);
        const double margin = ahead_of_contact * body.shape->bounds().diagonal().norm();
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            if (overlap(*body.shape, here, x.col(v), 0.5 * sheet.thickness[v] + margin).depth > 0)
                vertices.push_back(v);
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
    for (std::size_t a = 0; a < vertices.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) pairs.emplace_back(vertices[a], vertices[b]);
}

RigidBody BodyContact::moved(const Positions& x) const {
    solve(x);
    RigidBody result = body;
    result.centre += best.head<3>();
    result.rotation = Eigen::Quaterniond(pose(best).linear()).normalized().toRotationMatrix();
    result.velocity = best.head<3>() / step;
    result.angular_momentum = inertia * best.tail<3>() / step;
    return result;
}

double BodyContact::stored_energy(const Positions& x) const {
    return solve(x).stored;
}

Touch BodyContact::touch(const Positions& x) const {
    const Eigen::Isometry3d here = (solve(x), pose(best));
    Touch touch;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        touch.include(overlap(*body.shape, here, x.col(v), 0.5 * sheet.thickness[v]).depth);
    return touch;
}

}  // namespace sherd
