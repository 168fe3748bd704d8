// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/explicit/explicit_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contact/bodies/body_pose.h"
#include "core/contact/bodies/body_step.h"
#include "core/contact/bodies/point_contacts.h"
#include "core/contact/colliders/contact_colliders.h"
#include "core/contact/explicit/contact_forces.h"

namespace sherd {

ExplicitBodies::ExplicitBodies(const Shell& shell, std::vector<RigidBody> bodies,
                               const std::vector<Obstacle>& obstacles, const Vector3d& gravity,
                               std::span<const char> crossed)
    : shell(shell),
      obstacles(obstacles),
      gravity(gravity),
      all(std::move(bodies)),
      started(all),
      surfaces(surface_pairs(all, obstacles, crossed, true)),
      first_vertex(first_vertices(obstacles)) {
    for (std::size_t b = 0; b < all.size(); ++b) {
        at_vertices.emplace_back(shell, all[b], obstacles.size() + b);
        pairs.push_back(all[b].surface ? std::make_unique<NearPairs>(with_surface(b)) : nullptr);
    }
    points = point_contacts(all, obstacles.size());
    forces.resize(all.size());
    friction.resize(all.size());
    moved.resize(all.size(), Vector6d::Zero());
    measure_triangles();
}

ContactSurface ExplicitBodies::with_surface(std::size_t body) const {
    return surface_with(shell, all[body], obstacles.size() + body, true);
}

void ExplicitBodies::measure_triangles() {
    for (const TriangleStencil& triangle : shell.triangles)
        longest = std::max(longest, std::sqrt(2 * triangle.membrane.area));
}

void ExplicitBodies::shell_changed(const ShellChange& change) {
    for (std::size_t b = 0; b < all.size(); ++b)
        if (pairs[b]) pairs[b]->surface_changed(change, with_surface(b));
    measure_triangles();
}

void ExplicitBodies::begin(std::span<const Eigen::Isometry3d> places) {
    started = all;
    of_contact = of_friction = of_weight = 0;
    crossed_at_start = crossed();
    const std::vector<Eigen::Isometry3d> now = with_bodies(places);
    for (const auto& two : surfaces) two->place({now[two->body], now[two->other]});
}

void ExplicitBodies::restart() {
    all = started;
    for (std::size_t i = 0; i < surfaces.size(); ++i) surfaces[i]->set_crossed(crossed_at_start[i]);
}

const Collider& ExplicitBodies::collider(std::size_t number) const {
    if (number < all.size()) return all[number];
    return obstacles[number - all.size()];
}

void ExplicitBodies::kick(double length) {
    for (std::size_t b = 0; b < all.size(); ++b) {
        all[b].velocity += length / 2 * (forces[b].force / all[b].mass + gravity);
        all[b].angular_momentum += length / 2 * forces[b].torque;
    }
}

void ExplicitBodies::drift(double length) {
    for (std::size_t b = 0; b < all.size(); ++b) {
        moved[b] << length * all[b].velocity, length * all[b].spin();
        all[b].centre += moved[b].head<3>();
        const Matrix3d rotation = turned(moved[b].tail<3>()) * all[b].rotation;
        all[b].rotation = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
    }
}

void ExplicitBodies::add_body_force(std::size_t body, const Vector3d& at, const Vector3d& force) {
    forces[body].add(at - all[body].centre, force);
}

void ExplicitBodies::add_friction(std::size_t body, const Vector3d& at, const Vector3d& force) {
    add_body_force(body, at, force);
    friction[body].add(at - all[body].centre, force);
}

double ExplicitBodies::work(const Force& start, const Force& end, std::size_t body) const {
    return 0.5 * (start.force + end.force).dot(moved[body].head<3>()) +
           0.5 * (start.torque + end.torque).dot(moved[body].tail<3>());
}

Vector3d ExplicitBodies::velocity_at(std::size_t body, const Vector3d& at) const {
    return all[body].velocity + all[body].spin().cross(at - all[body].centre);
}

Positions ExplicitBodies::in_frame_of(const RigidBody& body, const Positions& x) {
    const Positions& of_body = body.surface->points;
    Positions together(3, of_body.cols() + x.cols());
    together << of_body, body.pose().inverse() * x;
    return together;
}

void ExplicitBodies::add_vertices(std::size_t body, const Substep& substep, ContactForces& sum) {
    const double coefficient = all[body].friction;
    at_vertices[body].add_springs(
        sum.vertices, substep.position, all[body].pose(), Curvature::convex,
        [&](Index v, const PointForce& spring) {
            const Vector3d at = substep.position.col(v), normal = spring.gradient.normalized();
            sum.force.col(v) -= spring.gradient;
            add_body_force(body, at, spring.gradient);
            if (coefficient > 0) {
                const Vector3d way = substep.velocity.col(v) - velocity_at(body, at);
                const Vector3d slip = way - normal * normal.dot(way);
                const Vector3d friction_force = explicit_friction(coefficient * spring.gradient.norm(), slip,
                                                                  shell.mass[v], substep.length);
                sum.add_friction(v, friction_force);
                add_friction(body, at, -friction_force);
            }
        });
}

double ExplicitBodies::mobility(std::size_t body, const Force& force) const {
    const Vector3d spun = all[body].rotation.transpose() * force.torque;
    return force.force.squaredNorm() / all[body].mass +
           spun.cwiseAbs2().cwiseQuotient(all[body].inertia).sum();
}

PairPositions ExplicitBodies::friction_of(std::size_t body, const ContactPair& pair, const PairPositions& at,
                                          const Substep& substep) const {
    const Index first = all[body].surface->size();
    PairPositions velocity;
    for (int i = 0; i < 4; ++i)
        velocity.col(i) = pair.vertices[i] < first ? velocity_at(body, at.col(i))
                                                   : Vector3d(substep.velocity.col(pair.vertices[i] - first));
    return pair_friction(
        pair, at, velocity, all[body].friction, substep.length, [&](const PairPositions& along) {
            double of_slip = 0;
            Force on_body;
            for (int i = 0; i < 4; ++i)
                if (pair.vertices[i] < first)
                    on_body.add(at.col(i) - all[body].centre, along.col(i));
                else
                    of_slip += along.col(i).squaredNorm() / shell.mass[pair.vertices[i] - first];
            return of_slip + mobility(body, on_body);
        });
}

void ExplicitBodies::add_pairs(std::size_t body, const Substep& substep, ContactForces& sum) {
    const Positions local = in_frame_of(all[body], substep.position);
    const Index first = all[body].surface->size();
    const auto is_followed = [&](Index v) {
        return v < first || std::ranges::binary_search(sum.vertices, v - first);
    };
    for (const ContactPair& pair : pairs[body]->active_pairs(local)) {
        if (!std::ranges::all_of(pair.vertices, is_followed)) continue;
        const PairPositions at = all[body].pose() * columns(local, pair.vertices);
        const PairPositions contact_force = -gradient(pair, at),
                            friction_force = friction_of(body, pair, at, substep);
        for (int i = 0; i < 4; ++i) {
            if (pair.vertices[i] < first) {
                add_body_force(body, at.col(i), contact_force.col(i));
                add_friction(body, at.col(i), friction_force.col(i));
            } else {
                sum.force.col(pair.vertices[i] - first) += contact_force.col(i);
                sum.add_friction(pair.vertices[i] - first, friction_force.col(i));
            }
        }
    }
}

template <class Add>
void ExplicitBodies::each_point(std::span<const Eigen::Isometry3d> places, Add add) const {
    for (const PointContact& contact : points) {
        const auto& [body, other, point] = contact;
        const Eigen::Isometry3d there = other < all.size() ? all[other].pose() : places[other - all.size()];
        const Vector3d at = all[body].pose() * point;
        const Overlap found = overlap(*collider(other).shape, there, at, all[body].contact_radius);
        if (found.depth > 0) add(body, other, found, at);
    }
}

bool ExplicitBodies::contact_points_push(const SurfacePairs& two,
                                         std::span<const Eigen::Isometry3d> places) const {
    bool hold = false;
    each_point(places, [&](std::size_t body, std::size_t other, const Overlap&, const Vector3d&) {
        hold |= (body == two.body && other == two.other) || (body == two.other && other == two.body);
    });
    return hold;
}

void ExplicitBodies::add_forces(const Substep& substep, std::span<const Eigen::Isometry3d> places_before,
                                std::span<const Eigen::Isometry3d> places, ContactForces& sum) {
    before = std::exchange(forces, std::vector<Force>(all.size()));
    friction_before = std::exchange(friction, std::vector<Force>(all.size()));
    for (std::size_t b = 0; b < all.size(); ++b) {
        add_vertices(b, substep, sum);
        if (pairs[b]) add_pairs(b, substep, sum);
    }
    add_points(substep, places_before, places, sum);
    add_surfaces(substep.length, places, sum);
    for (std::size_t b = 0; b < all.size(); ++b) {
        of_contact += work(before[b], forces[b], b);
        of_friction += work(friction_before[b], friction[b], b);
        of_weight += all[b].mass * gravity.dot(moved[b].head<3>());
        moved[b].setZero();  // so that the work is counted once
    }
}

void ExplicitBodies::add_points(const Substep& substep, std::span<const Eigen::Isometry3d> places_before,
                                std::span<const Eigen::Isometry3d> places, ContactForces& sum) {
    each_point(places, [&](std::size_t body, std::size_t other, const Overlap& found, const Vector3d& at) {
        const bool free = other < all.size();
        const double stiffness = all[body].point_stiffness(collider(other));
        const PointForce contact_force = spring(found, stiffness, Curvature::convex);
        const Vector3d normal = found.normal.normalized();
        const Vector3d touched = at - all[body].contact_radius * normal;
        const Vector3d there = free ? velocity_at(other, touched)
                                    : velocity_of_point(places_before[other - all.size()],
                                                        places[other - all.size()], touched, substep.length);
        const Vector3d way = velocity_at(body, touched) - there, slip = way - normal * normal.dot(way);
        const double arm = (touched - all[body].centre).squaredNorm();
        const double mass = all[body].mass / (1 + all[body].mass * arm / all[body].inertia.minCoeff());
        const Vector3d friction_force =
            explicit_friction(friction_between(all[body], collider(other)) * contact_force.gradient.norm(),
                              slip, mass, substep.length);
        add_body_force(body, at, -contact_force.gradient);
        add_friction(body, touched, friction_force);
        if (free) {
            add_body_force(other, at, contact_force.gradient);
            add_friction(other, touched, -friction_force);
        } else {
            sum.obstacles[other - all.size()].add(touched, -contact_force.gradient);
            sum.add_friction(other - all.size(), touched, friction_force);
        }
    });
}

double ExplicitBodies::stored_energy(const Positions& x, std::span<const Eigen::Isometry3d> places) const {
    double sum = 0;
    for (std::size_t b = 0; b < all.size(); ++b) {
        at_vertices[b].add_springs(x, all[b].pose(), Curvature::convex,
                                   [&](Index, const PointForce& spring) { sum += spring.value; });
        if (!pairs[b]) continue;
        const Positions local = in_frame_of(all[b], x);
        for (const ContactPair& pair : pairs[b]->active_pairs(local))
            sum += value(pair, columns(local, pair.vertices));
    }
    each_point(places, [&](std::size_t body, std::size_t other, const Overlap& found, const Vector3d&) {
        sum += spring(found, all[body].point_stiffness(collider(other)), Curvature::convex).value;
    });
    const std::vector<Eigen::Isometry3d> now = with_bodies(places);
    for (const auto& two : surfaces)
        two->each_active({now[two->body], now[two->other]},
                         [&](const ContactPair& pair, const PairPositions& at) { sum += value(pair, at); });
    return sum;
}

double ExplicitBodies::displacement(std::size_t body, double length) const {
    const RigidBody& moving = all[body];
    double radius = moving.surface ? moving.surface->points.colwise().norm().maxCoeff() : 0;
    for (const Vector3d& point : moving.contact_points)
        radius = std::max(radius, point.norm() + moving.contact_radius);
    return length * (moving.velocity.norm() + moving.spin().norm() * radius + length * gravity.norm());
}

void ExplicitBodies::add_rates(const StepContext& step, double way, double margin, ContactRates& sum) const {
    double largest = 0, of_points = 0;
    // The body's shape acts on a vertex with the stiffness of a column of sheet. The body's surface acts with
    // half of this stiffness through each of the two kinds of pair, hence the factor of two. If the body
    // touches an edge or a face, the vertices of that element may be away from the body by up to the
    // element's size, hence `longest`.
    for (std::size_t b = 0; b < all.size(); ++b) {
        const double reach = way + margin * displacement(b, step.length) + (pairs[b] ? longest : 0);
        const double of_second = rate_of_second_springs(b, step, reach);
        at_vertices[b].each_rate(step.origin, all[b].pose(), reach, [&](Index v, double rate) {
            sum.of_vertices[v] += 2 * rate + of_second;
            largest = std::max(largest, 2 * rate + of_second);
        });
    }
    for (const auto& [body, other, point] : points) {
        const double turning = all[body].mass * point.squaredNorm() / all[body].inertia.minCoeff();
        const double stiffness = all[body].point_stiffness(collider(other));
        of_points =
            std::max(of_points, all[body].points_at_once() * stiffness / all[body].mass * (1 + turning));
    }
    sum.of_bodies = std::max(largest, of_points + rate_of_surfaces(step));
}

void ExplicitBodies::add_touch(const Positions& x, std::span<const Eigen::Isometry3d> places,
                               Touch& touch) const {
    for (std::size_t b = 0; b < all.size(); ++b) {
        Touch own;
        at_vertices[b].add_touch(x, all[b].pose(), own);
        std::set<const ColliderSurface*> itself;
        if (pairs[b]) pairs[b]->add_touched(in_frame_of(all[b], x), own.vertices, itself);
        if (!own.vertices.empty()) touch.bodies.insert(b);
        touch.include(own);
    }
    const auto include = [&](std::size_t body, std::size_t other) {
        touch.bodies.insert(body);
        if (other < all.size())
            touch.bodies.insert(other);
        else
            touch.obstacles.insert(other - all.size());
    };
    each_point(places, [&](std::size_t body, std::size_t other, const Overlap&, const Vector3d&) {
        include(body, other);
    });
    const std::vector<Eigen::Isometry3d> now = with_bodies(places);
    for (const auto& two : surfaces)
        if (two->touch({now[two->body], now[two->other]})) include(two->body, two->other);
}

double ExplicitBodies::kinetic_change() const {
    double sum = 0;
    for (std::size_t b = 0; b < all.size(); ++b) sum += all[b].kinetic_energy() - started[b].kinetic_energy();
    return sum;
}

}  // namespace sherd
