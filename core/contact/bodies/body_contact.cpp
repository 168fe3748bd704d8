// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_contact.h"

#include <algorithm>

namespace sherd {
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
      sticks_with_shell(started.size()),
      at(Positions::Zero(3, static_cast<Eigen::Index>(2 * started.size()))) {
    for (std::size_t b = 0; b < started.size(); ++b)
        pairs.push_back(started[b].surface ? std::make_unique<NearPairs>(with_surface(b)) : nullptr);
}

ContactSurface BodyContact::with_surface(std::size_t body) const {
    return surface_with(shell, started[body], obstacles.size() + body);
}

void BodyContact::begin(const StepContext& step) {
    started = finished;
    at.setZero();
    make_steps(step);
    is_blocked = !have_straight_paths(shell.position + step.length * shell.velocity);
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
        steps.emplace_back(shell, started[b], gravity, step, step.bodies[b], pairs[b].get(), b,
                           obstacles.size(), sticks_with_shell[b]);
    points = point_contacts(started, obstacles.size());
    sliding.clear();
    place_obstacles(step.begin);
    start_stored = stored_energy(shell.position, poses(Positions::Zero(3, at.cols())));
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
    const std::vector<BodyPose> start = poses(Positions::Zero(3, at.cols()));
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

std::vector<BodyPose> BodyContact::poses(const Positions& columns) const {
    const auto first = columns.cols() - static_cast<Eigen::Index>(2 * steps.size());
    std::vector<BodyPose> all;
    for (std::size_t b = 0; b < steps.size(); ++b)
        all.push_back(steps[b].pose(columns.middleCols<2>(first + static_cast<Eigen::Index>(2 * b))));
    for (const Eigen::Isometry3d& place : obstacle_places) all.push_back({place, Matrix3d::Zero()});
    return all;
}

Positions BodyContact::with_bodies(const Positions& x) const {
    Positions all(3, x.cols() + at.cols());
    all << x, at;
    return all;
}

Overlap BodyContact::overlap_of(const PointContact& contact, const std::vector<BodyPose>& poses,
                                double margin) const {
    return overlap(*collider(contact.other).shape, poses[contact.other].place,
                   poses[contact.body].place * contact.point, started[contact.body].contact_radius + margin);
}

template <class Add>
void BodyContact::each_point_force(const std::vector<BodyPose>& poses, Add add) const {
    const auto add_point = [&](std::size_t body, const Vector3d& x, std::size_t other, const Vector3d& anchor,
                               const PointForce& force, bool elastic) {
        add(BodyForce::between({-1, body}, x, other, anchor, force, elastic),
            [&] { return between_points(force.hessian); });
    };
    for (const PointContact& contact : points) {
        const Overlap overlap = overlap_of(contact, poses);
        if (overlap.depth <= 0) continue;
        const Vector3d x = poses[contact.body].place * contact.point;
        const double stiffness = started[contact.body].point_stiffness(collider(contact.other));
        add_point(contact.body, x, contact.other, x, spring(overlap, stiffness, Curvature::convex), true);
    }
    for (const SlidingContact& contact : sliding) {
        const Vector3d x = poses[contact.body].place * contact.point,
                       anchor = poses[contact.other].place * contact.sliding.anchor;
        add_point(contact.body, x, contact.other, anchor, contact.sliding.force(x, anchor), false);
    }
}

template <class Add>
void BodyContact::each_surface_force(const std::vector<BodyPose>& poses, Add add) const {
    for (const auto& pairs_of_two : surfaces_of_step()) {
        const SurfacePairs& two = *pairs_of_two;
        const PairPlaces places = places_of(two, poses);
        const auto points_of = [&](const std::array<Index, 4>& vertices) {
            std::array<BodyForce::Point, 4> all;
            for (int i = 0; i < 4; ++i) all[i] = {-1, vertices[i] < two.first() ? two.other : two.body};
            return all;
        };
        two.each_active(places, [&](const ContactPair& pair, const PairPositions& x) {
            add(BodyForce::of(pair, points_of(pair.vertices), x, two.moved(pair.vertices, places)),
                [&] { return hessian(pair, x, true); });
        });
        for (const SlidingPair& pair : two.sliding()) {
            const PairPositions way = two.moved(pair.vertices, places);
            add(BodyForce::of(pair, points_of(pair.vertices), two.in_space(pair.vertices, places), way),
                [&] { return pair.hessian(way); });
        }
    }
}

template <class Add>
void BodyContact::each_force(const Positions& x, const std::vector<BodyPose>& poses, Add add) const {
    for (std::size_t b = 0; b < steps.size(); ++b) steps[b].each_force(x, poses[b], add);
    each_point_force(poses, add);
    each_surface_force(poses, add);
}

template <class Use>
void BodyContact::each_column(const BodyForce& force, const std::vector<BodyPose>& poses, Use use) const {
    for (int i = 0; i < force.count; ++i) {
        const auto& [vertex, number] = force.points[i];
        if (vertex >= 0) {
            use(i, vertex, Matrix3d(Matrix3d::Identity()));
        } else if (is_free(number)) {
            use(i, first_column(number), Matrix3d(Matrix3d::Identity()));
            use(i, first_column(number) + 1, poses[number].turning(force.at.col(i)));
        }
    }
}

double BodyContact::value(const Positions& x) const {
    double sum = 0;
    each_force(shell_part(x), poses(x), [&](const BodyForce& force, const auto&) { sum += force.value; });
    return sum;
}

void BodyContact::add_gradient(const Positions& x, Positions& gradient) const {
    const std::vector<BodyPose> all = poses(x);
    each_force(shell_part(x), all, [&](const BodyForce& force, const auto&) {
        each_column(force, all, [&](int point, Index column, const Matrix3d& motion) {
            gradient.col(column) += motion.transpose() * force.gradient.col(point);
        });
    });
}

void BodyContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    struct Column {
        int point;
        Index number;
        Matrix3d motion;
    };
    const std::vector<BodyPose> all = poses(x);
    std::vector<Column> columns;
    each_force(shell_part(x), all, [&](const BodyForce& force, const auto& second_derivative) {
        const PairHessian twice = second_derivative();
        columns.clear();
        each_column(force, all, [&](int point, Index number, const Matrix3d& motion) {
            columns.push_back({point, number, motion});
        });
        for (std::size_t i = 0; i < columns.size(); ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                const auto& [one, row, by_row] = columns[i];
                const auto& [other, column, by_column] = columns[j];
                const Matrix3d block = by_row.transpose() * twice.block<3, 3>(3 * one, 3 * other) * by_column;
                const Matrix3d both = block + block.transpose();
                hessian.add(row, column, row != column ? block : Matrix3d((i == j ? 0.5 : 1) * both));
            }
    });
}

void BodyContact::add_contacts(const Positions& x, bool ahead,
                               std::vector<std::pair<Index, Index>>& found) const {
    const std::vector<BodyPose> all = poses(x);
    std::vector<Index> columns;
    each_force(shell_part(x), all, [&](const BodyForce& force, const auto&) {
        columns.clear();
        each_column(force, all, [&](int, Index column, const Matrix3d&) {
            for (const Index other : columns)
                if (other != column) found.emplace_back(column, other);
            columns.push_back(column);
        });
    });
    if (ahead) add_upcoming(x, found);
}

void BodyContact::add_upcoming(const Positions& x, std::vector<std::pair<Index, Index>>& found) const {
    const std::vector<BodyPose> all = poses(x);
    const auto add_columns_of = [&](std::size_t body, Index other) {
        for (const Index column : {first_column(body), first_column(body) + 1})
            found.emplace_back(column, other);
    };
    const auto add_both = [&](std::size_t one, std::size_t other) {
        for (const Index column : {first_column(other), first_column(other) + 1}) add_columns_of(one, column);
    };
    for (std::size_t b = 0; b < steps.size(); ++b) {
        std::set<Index> near;
        steps[b].add_near(shell_part(x), all[b], near, found);
        found.emplace_back(first_column(b) + 1, first_column(b));
        for (const Index vertex : near) add_columns_of(b, vertex);
    }
    for (const PointContact& contact : points) {
        if (!is_free(contact.other)) continue;
        const double margin = ahead_of_contact * started[contact.other].shape->bounds().diagonal().norm();
        if (overlap_of(contact, all, margin).depth > 0) add_both(contact.body, contact.other);
    }
    for (const auto& pair : surfaces_of_step())
        if (is_free(pair->other) && are_near(*pair, all)) add_both(pair->body, pair->other);
}

bool BodyContact::are_near(const SurfacePairs& pair, const std::vector<BodyPose>& poses) const {
    const double reach = 0.5 * (started[pair.body].shape->bounds().diagonal().norm() +
                                started[pair.other].shape->bounds().diagonal().norm());
    const PairPlaces places = places_of(pair, poses);
    return (places.here.translation() - places.there.translation()).norm() < (1 + ahead_of_contact) * reach;
}

void BodyContact::end_step() {
    for (std::size_t b = 0; b < steps.size(); ++b) ended[b] = steps[b].moved(placed(b));
}

void BodyContact::finish(const Positions& x) {
    end_step();
    finished = ended;
    const std::vector<BodyPose> at_end = poses(at);
    for (std::size_t b = 0; b < steps.size(); ++b)
        sticks_with_shell[b] = steps[b].elastic_slip_after(x, placed(b));
    sticks_with_points.clear();
    for (const auto& [number, body, other, point, friction] : sliding)
        sticks_with_points.keep(number, friction.elastic_slip_after(at_end[body].place * point,
                                                                    at_end[other].place * friction.anchor));
    for (const auto& pair : surfaces) pair->finish(places_of(*pair, at_end));
}

double BodyContact::stored_energy(const Positions& x, const std::vector<BodyPose>& poses) const {
    double sum = 0;
    each_force(x, poses, [&](const BodyForce& force, const auto&) {
        if (force.elastic) sum += force.value;
    });
    return sum;
}

double BodyContact::friction_loss(const Positions& x) const {
    double sum = 0;
    each_force(x, poses(at), [&](const BodyForce& force, const auto&) {
        if (!force.elastic) sum += force.work();
    });
    return sum;
}

double BodyContact::work_of_all() const {
    double sum = 0;
    for (std::size_t b = 0; b < steps.size(); ++b)
        sum += steps[b].momentum_rate(ended[b]).dot(steps[b].motion(placed(b)));
    return sum;
}

double BodyContact::contact_work() const {
    double weight = 0;
    for (std::size_t b = 0; b < steps.size(); ++b) weight += started[b].mass * gravity.dot(placed(b).col(0));
    return work_of_all() - weight;
}

double BodyContact::kinetic_change() const {
    double sum = 0;
    for (std::size_t b = 0; b < steps.size(); ++b)
        sum += ended[b].kinetic_energy() - started[b].kinetic_energy();
    return sum;
}

double BodyContact::work_of_deforming() const {
    double sum = 0;
    each_surface_force(poses(at), [&](const BodyForce& force, const auto&) {
        for (int i = 0; i < force.count; ++i) {
            const std::size_t number = force.points[i].collider;
            if (!is_free(number) && obstacles[number - steps.size()].deformation != nullptr)
                sum += force.gradient.col(i).dot(force.moved.col(i));
        }
    });
    return sum;
}

void BodyContact::add_reactions(std::span<Reaction> of_obstacles) const {
    const auto add = [&](const BodyForce& force, const auto&) {
        // An obstacle has the greater number of the two colliders between which the force acts.
        std::size_t number = 0;
        for (int i = 0; i < force.count; ++i) number = std::max(number, force.points[i].collider);
        for (int i = 0; i < force.count && !is_free(number); ++i)
            if (is_free(force.points[i].collider))
                of_obstacles[number - steps.size()].add(force.at.col(i), -force.gradient.col(i));
    };
    each_point_force(poses(at), add);
    each_surface_force(poses(at), add);
}

void BodyContact::add_touch(const Positions& x, Touch& touch) const {
    const std::vector<BodyPose> all = poses(at);
    for (std::size_t b = 0; b < steps.size(); ++b) {
        const Touch own = steps[b].touch(x, all[b]);
        if (!own.vertices.empty()) touch.bodies.insert(b);
        touch.include(own);
    }
    const auto include = [&](std::size_t body, std::size_t other) {
        touch.bodies.insert(body);
        if (is_free(other))
            touch.bodies.insert(other);
        else
            touch.obstacles.insert(other - steps.size());
    };
    for (const PointContact& contact : points)
        if (overlap_of(contact, all).depth > 0) include(contact.body, contact.other);
    for (const auto& pair : surfaces_of_step())
        if (pair->touch(places_of(*pair, all))) include(pair->body, pair->other);
}

}  // namespace sherd
