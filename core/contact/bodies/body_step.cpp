// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_step.h"

#include <Eigen/LU>
#include <algorithm>

namespace sherd {
namespace {

constexpr double ahead_of_contact = 0.1;  // of the body's size: vertices that may soon touch
constexpr double largest_turn = 1;        // rad, between two poses that are tried one after the other

/// A matrix of four vertices' blocks in axes that are turned.
PairHessian turned_blocks(const PairHessian& matrix, const Matrix3d& rotation) {
    PairHessian result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            result.block<3, 3>(3 * i, 3 * j) =
                rotation * matrix.block<3, 3>(3 * i, 3 * j) * rotation.transpose();
    return result;
}

}  // namespace

ContactSurface surface_with(const Sheet& sheet, const RigidBody& body) {
    return ContactSurface(sheet, {{body.surface.get(), body.young, body.friction, {}}}, false);
}

BodyStep::BodyStep(const Sheet& sheet, const RigidBody& body, const std::vector<Obstacle>& obstacles,
                   const Vector3d& gravity, const StepContext& step, const BodyOrigin& origin,
                   const NearPairs* near)
    : sheet(sheet),
      body(body),
      obstacles(obstacles),
      near(near),
      lag(step.lag),
      end(step.end()),
      origin(origin),
      inertia(body.inertia_in_space()) {
    predicted = origin.pose + lag * origin.velocity;
    predicted.head<3>() += lag * lag * gravity;
    if (body.friction == 0) return;
    find_sliding(step);
    find_sliding_feet(step);
}

void BodyStep::find_sliding(const StepContext& step) {
    const BodyPose start = pose(Vector6d::Zero());
    for (Index v = 0; v < static_cast<Index>(sheet.position.cols()); ++v) {
        const Vector3d x = sheet.position.col(v);
        const Overlap at = overlap(*body.shape, start.place, x, 0.5 * sheet.thickness[v]);
        if (at.depth > 0)
            sliding.push_back({v,
                               start.place.inverse() * x,
                               Matrix3d::Identity() - at.normal * at.normal.transpose(),
                               {body.friction * stiffness(v) * at.depth, smoothing_speed * step.lag}});
    }
    if (!near) return;
    const Positions local = seen_from(start, sheet.position), space = start.place * local;
    for (const ContactPair& pair : near->touching(local))
        sliding_pairs.push_back(sliding_pair(pair, columns(space, pair.vertices), body.friction, step.lag));
}

void BodyStep::find_sliding_feet(const StepContext& step) {
    const BodyPose start = pose(Vector6d::Zero());
    for (const Obstacle& obstacle : obstacles) {
        if (obstacle.friction == 0) continue;
        const Eigen::Isometry3d before = obstacle.motion.at(step.begin);
        const Eigen::Isometry3d carried = obstacle.motion.at(end) * before.inverse();
        for (const Vector3d& foot : body.feet) {
            const Overlap at = overlap(*obstacle.shape, before, start.place * foot, body.skin);
            if (at.depth <= 0) continue;
            const Vector3d touching = start.place * foot - body.skin * at.normal;
            const Vector3d normal = carried.linear() * at.normal;
            const double force = stiffness(obstacle) * at.depth;
            sliding_feet.push_back(
                {start.place.inverse() * touching,
                 carried * touching,
                 Matrix3d::Identity() - normal * normal.transpose(),
                 {friction_between(body.friction, obstacle.friction) * force, smoothing_speed * step.lag}});
        }
    }
}

double BodyStep::stiffness(Eigen::Index vertex) const {
    return column_stiffness(sheet.footprint[vertex], sheet.thickness[vertex], sheet.young[vertex],
                            body.young);
}

BodyPose BodyStep::pose(const Vector6d& q) const {
    BodyPose pose{Eigen::Isometry3d::Identity(), rotation_jacobian(q.tail<3>())};
    pose.place.linear() = turned(q.tail<3>()) * body.rotation;
    pose.place.translation() = body.centre + q.head<3>();
    return pose;
}

Positions BodyStep::seen_from(const BodyPose& pose, const Positions& x) const {
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

void BodyStep::add_obstacles(const BodyPose& here, BodyPotential& sum) const {
    for (const Obstacle& obstacle : obstacles) {
        const double k = stiffness(obstacle);
        const Eigen::Isometry3d there = obstacle.motion.at(end);
        for (const Vector3d& foot : body.feet) {
            const Overlap at = overlap(*obstacle.shape, there, here.place * foot, body.skin);
            if (at.depth <= 0) continue;
            const Vector6d slope = here.point_motion(here.place.linear() * foot).transpose() * at.normal;
            sum.stored += 0.5 * k * at.depth * at.depth;
            sum.gradient -= k * at.depth * slope;
            sum.hessian += k * slope * slope.transpose();
        }
    }
    for (const SlidingFoot& foot : sliding_feet) {
        const Vector3d slip = foot.tangent * (here.place * foot.point - foot.other);
        const Matrix36d motion = here.point_motion(here.place.linear() * foot.point);
        sum.value += foot.friction.value(slip);
        sum.gradient += motion.transpose() * foot.friction.gradient(slip);
        sum.hessian += motion.transpose() * foot.friction.hessian(slip, foot.tangent) * motion;
    }
}

void BodyStep::add_vertices(const Positions& x, const BodyPose& here, BodyPotential& sum) const {
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        const Overlap at = overlap(*body.shape, here.place, x.col(v), 0.5 * sheet.thickness[v]);
        if (at.depth <= 0) continue;
        const double k = stiffness(v);
        sum.stored += 0.5 * k * at.depth * at.depth;
        sum.add_vertex(here, v, -k * at.depth * at.normal, k * at.normal * at.normal.transpose(),
                       x.col(v) - here.place.translation());
    }
    for (const Sliding& slider : sliding) {
        const Vector3d slip = slider.tangent * (x.col(slider.vertex) - here.place * slider.foot);
        sum.value += slider.friction.value(slip);
        sum.add_vertex(here, slider.vertex, slider.friction.gradient(slip),
                       slider.friction.hessian(slip, slider.tangent), here.place.linear() * slider.foot);
    }
}

void BodyStep::add_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const {
    const Positions& points = body.surface->points;
    const Positions local = seen_from(here, x);
    const Matrix3d rotation = here.place.linear();
    for (const ContactPair& pair : near->touching(local)) {
        const PairPositions at = columns(local, pair.vertices);
        sum.stored += sherd::value(pair, at);
        sum.add_element(here, pair.vertices, body.surface->size(), points, rotation * gradient(pair, at),
                        turned_blocks(hessian(pair, at, true), rotation));
    }
}

void BodyStep::add_sliding_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const {
    const Positions& points = body.surface->points;
    const Eigen::Isometry3d before = pose(Vector6d::Zero()).place;
    for (const SlidingPair& pair : sliding_pairs) {
        PairPositions moved;
        for (int i = 0; i < 4; ++i) {
            const Index vertex = pair.vertices[i];
            if (vertex < body.surface->size())
                moved.col(i) =
                    here.place * Vector3d(points.col(vertex)) - before * Vector3d(points.col(vertex));
            else
                moved.col(i) =
                    x.col(vertex - body.surface->size()) - sheet.position.col(vertex - body.surface->size());
        }
        const Vector3d slip = pair.slip * moved.reshaped();
        sum.value += pair.friction.value(slip);
        const Eigen::Matrix<double, 12, 1> slope = pair.slip.transpose() * pair.friction.gradient(slip);
        sum.add_element(here, pair.vertices, body.surface->size(), points, slope.reshaped(3, 4),
                        pair.slip.transpose() * pair.friction.hessian(slip, pair.tangent) * pair.slip);
    }
}

BodyPotential BodyStep::potential(const Positions& x, const Vector6d& q) const {
    const BodyPose here = pose(q);
    BodyPotential sum;
    add_inertia(q, sum);
    add_obstacles(here, sum);
    add_vertices(x, here, sum);
    if (near) {
        add_pairs(x, here, sum);
        add_sliding_pairs(x, here, sum);
    }
    sum.value += sum.stored;
    return sum;
}

double BodyStep::free_way(const Positions& x, const Vector6d& from, const Vector6d& to) const {
    if (!near) return 1;
    const BodyPose before = pose(from), after = pose(to);
    const double angle = Eigen::AngleAxisd(before.place.linear().transpose() * after.place.linear()).angle();
    // Seen from the body, the straight motion takes the sheet through images of itself that are not folded
    // over as long as the angle is less than pi.
    if (angle > largest_turn) return 0.5 * largest_turn / angle;
    const Positions start = seen_from(before, x);
    return near->safe_fraction(start, seen_from(after, x) - start);
}

double BodyStep::free_motion(const Positions& x, const Positions& motion, const Vector6d& q) const {
    if (!near) return 1;
    const BodyPose here = pose(q);
    const Positions start = seen_from(here, x);
    return near->safe_fraction(start, seen_from(here, x + motion) - start);
}

void BodyStep::add_near_vertices(const Positions& x, const Vector6d& q, std::set<Index>& vertices) const {
    const BodyPose here = pose(q);
    const double margin = ahead_of_contact * body.shape->bounds().diagonal().norm();
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        if (overlap(*body.shape, here.place, x.col(v), 0.5 * sheet.thickness[v] + margin).depth > 0)
            vertices.insert(v);
    std::vector<std::pair<Index, Index>> soon;
    if (near) near->add_contacts(seen_from(here, x), true, soon);
    for (const auto& [a, b] : soon) vertices.insert({a, b});
}

RigidBody BodyStep::moved(const Vector6d& q) const {
    const BodyPose here = pose(q);
    RigidBody result = body;
    result.centre += q.head<3>();
    result.rotation = Eigen::Quaterniond(here.place.linear()).normalized().toRotationMatrix();
    result.velocity = (q.head<3>() - origin.pose.head<3>()) / lag;
    // Of P, the rotation feels torques times the Jacobian; the angular momentum takes them as they are, or
    // what the sheet gains would not be what the body loses.
    const Vector3d turned_by_torque = inertia * (q.tail<3>() - predicted.tail<3>()) / lag;
    result.angular_momentum += here.jacobian.transpose().inverse() * turned_by_torque;
    return result;
}

Touch BodyStep::touch(const Positions& x, const Vector6d& q) const {
    Touch touch;
    const BodyPose here = pose(q);
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        touch.include(v, overlap(*body.shape, here.place, x.col(v), 0.5 * sheet.thickness[v]).depth);
    std::set<const SolidSurface*> itself;
    if (near) near->add_touched(seen_from(here, x), touch.vertices, itself);
    const auto rests_on = [&](const Obstacle& obstacle) {
        return std::any_of(body.feet.begin(), body.feet.end(), [&](const Vector3d& foot) {
            return overlap(*obstacle.shape, obstacle.motion.at(end), here.place * foot, body.skin).depth > 0;
        });
    };
    for (std::size_t o = 0; o < obstacles.size(); ++o)
        if (rests_on(obstacles[o])) touch.obstacles.insert(o);
    return touch;
}

}  // namespace sherd
