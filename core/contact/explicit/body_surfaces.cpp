// SPDX-License-Identifier: GPL-3.0-or-later
// Member functions of ExplicitBodies (explicit_bodies.h) for contact of the bodies' surfaces with the shell,
// with each other and with the surfaces of obstacles.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/contact/bodies/body_pose.h"
#include "core/contact/explicit/contact_forces.h"
#include "core/contact/explicit/explicit_bodies.h"

namespace sherd {
namespace {

/// Upper bound on the mobility (velocity per impulse), 1/kg, of a point of a body at a distance `arm`, m,
/// from its centre of mass.
double largest_mobility(const RigidBody& body, double arm) {
    return 1 / body.mass + arm * arm / body.inertia.minCoeff();
}

/// Rotation vector, rad, of a body from the state `from` to the state `to`, `length` s later, whole turns
/// included.
Vector3d turn_of(const RigidBody& from, const RigidBody& to, double length) {
    const Eigen::AngleAxisd turn(to.rotation * from.rotation.transpose());
    const double spun = 0.5 * length * (from.spin() + to.spin()).dot(turn.axis());
    const double whole = 2 * std::numbers::pi;
    return (turn.angle() + whole * std::round((spun - turn.angle()) / whole)) * turn.axis();
}

}  // namespace

bool ExplicitBodies::passes_shell(std::size_t body, const StepContext& step, const Positions& end) const {
    const RigidBody &from = started[body], &to = all[body];
    const Vector3d turn = turn_of(from, to, step.length);
    return pairs[body] && pairs[body]->passes_in_parts(straight_parts(turn.norm()), [&](double share) {
        RigidBody then = share == 0 ? from : to;
        if (share > 0 && share < 1) {
            then.centre = from.centre + share * (to.centre - from.centre);
            then.rotation = turned(share * turn) * from.rotation;
        }
        return in_frame_of(then, step.origin + share * (end - step.origin));
    });
}

bool ExplicitBodies::pass_shell(const StepContext& step, const Positions& end) const {
    for (std::size_t b = 0; b < all.size(); ++b)
        if (passes_shell(b, step, end)) return true;
    return false;
}

bool ExplicitBodies::allow_barriers(const Positions& x) const {
    for (std::size_t b = 0; b < all.size(); ++b)
        if (pairs[b] && !pairs[b]->allow_barriers(in_frame_of(all[b], x))) return false;
    return true;
}

double ExplicitBodies::least_share(const std::vector<RigidBody>& places, const Positions& x) const {
    double least = 1;
    for (std::size_t b = 0; b < all.size(); ++b)
        if (pairs[b]) least = std::min(least, pairs[b]->least_share(in_frame_of(places[b], x)));
    return least;
}

void ExplicitBodies::set_second_spring(SecondSpring second_spring) {
    for (const auto& of_body : pairs)
        if (of_body) of_body->set_second_spring(second_spring);
}

double ExplicitBodies::rate_of_second_springs(std::size_t body, const StepContext& step,
                                              double margin) const {
    const double times = pairs[body] ? pairs[body]->second_spring().stiffness() : 0;
    if (times == 0) return 0;
    const RigidBody& of = all[body];
    const double radius = of.surface->points.colwise().norm().maxCoeff();
    const double total = at_vertices[body].total_stiffness(step.origin, of.pose(), margin);
    double largest = 0;
    at_vertices[body].each_rate(step.origin, of.pose(), margin,
                                [&](Index, double rate) { largest = std::max(largest, rate); });
    return times * (largest + total * largest_mobility(of, radius));
}

std::vector<Eigen::Isometry3d> ExplicitBodies::with_bodies(std::span<const Eigen::Isometry3d> places) const {
    std::vector<Eigen::Isometry3d> together;
    if (surfaces.empty()) return together;
    for (const RigidBody& body : all) together.push_back(body.pose());
    together.insert(together.end(), places.begin(), places.end());
    return together;
}

void ExplicitBodies::move_to(double time) {
    for (const auto& two : surfaces) two->move_to(time);
}

void ExplicitBodies::update_exemption(std::span<const Eigen::Isometry3d> places) {
    const std::vector<Eigen::Isometry3d> now = with_bodies(places);
    for (const auto& two : surfaces) two->update_exemption({now[two->body], now[two->other]});
}

PairPositions ExplicitBodies::friction_of(const SurfacePairs& two, const ContactPair& pair,
                                          const PairPositions& at, const PairPlaces& places, double sharing,
                                          double length) const {
    const bool free = two.other < all.size();
    const PairPositions moved = two.moved(pair.vertices, places);
    const auto is_own = [&](int i) { return pair.vertices[i] >= two.first(); };
    PairPositions velocity;
    for (int i = 0; i < 4; ++i)
        velocity.col(i) = is_own(i) || free ? velocity_at(is_own(i) ? two.body : two.other, at.col(i))
                                            : Vector3d(moved.col(i) / length);
    return pair_friction(pair, at, velocity, two.coefficient(), length, [&](const PairPositions& along) {
        Force on_body, on_other;
        for (int i = 0; i < 4; ++i)
            if (is_own(i))
                on_body.add(at.col(i) - all[two.body].centre, along.col(i));
            else if (free)
                on_other.add(at.col(i) - all[two.other].centre, along.col(i));
        return sharing * (mobility(two.body, on_body) + (free ? mobility(two.other, on_other) : 0));
    });
}

void ExplicitBodies::add_surface_pair(const SurfacePairs& two, const PairPositions& at,
                                      const std::array<Index, 4>& vertices,
                                      const PairPositions& contact_force, const PairPositions& friction_force,
                                      ContactForces& sum) {
    const bool free = two.other < all.size();
    const std::size_t obstacle = two.other - all.size();
    for (int i = 0; i < 4; ++i) {
        const bool own = vertices[i] >= two.first();
        if (own || free) {
            add_body_force(own ? two.body : two.other, at.col(i), contact_force.col(i));
            add_friction(own ? two.body : two.other, at.col(i), friction_force.col(i));
        }
        if (own && !free) {
            sum.obstacles[obstacle].add(at.col(i), contact_force.col(i));
            sum.add_friction(obstacle, at.col(i), friction_force.col(i));
        }
        if (!own && !free) {
            sum.add_collider_force(first_vertex[obstacle] + vertices[i], contact_force.col(i));
            sum.add_collider_friction(first_vertex[obstacle] + vertices[i], friction_force.col(i));
        }
    }
}

void ExplicitBodies::add_surfaces(double length, std::span<const Eigen::Isometry3d> obstacle_places,
                                  ContactForces& sum) {
    const std::vector<Eigen::Isometry3d> now = with_bodies(obstacle_places);
    for (const auto& met : surfaces) {
        const PairPlaces places{now[met->body], now[met->other]};
        if (met->passes(places) && !contact_points_push(*met, obstacle_places))
            throw std::runtime_error(
                "contact: a free body passes through another one, or through an obstacle: the springs of "
                "explicit contact are too weak; a stiffer body, less speed, or implicit steps may help");
        // Each pair alone may stop the sliding of the whole body, so that all pairs together must share its
        // mass.
        const double sharing = met->coefficient() > 0 ? met->count_active(places) : 0;
        met->each_active(places, [&](const ContactPair& pair, const PairPositions& at) {
            add_surface_pair(*met, at, pair.vertices, -gradient(pair, at),
                             friction_of(*met, pair, at, places, sharing, length), sum);
        });
        met->place(places);
    }
}

Positions ExplicitBodies::motion_of(const SurfacePairs& two, const StepContext& step,
                                    const Positions& points) const {
    const bool free = two.other < all.size();
    Eigen::Isometry3d there = Eigen::Isometry3d::Identity(), there_then = there;
    if (free) {
        there = all[two.other].pose();
    } else {
        const Motion& motion = obstacles[two.other - all.size()].motion;
        there = motion.at(step.begin), there_then = motion.at(step.end());
    }
    Positions moved(3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vector3d at = points.col(i);
        const Vector3d of_other =
            free ? velocity_at(two.other, at) : velocity_of_point(there, there_then, at, step.length);
        const Vector3d velocity = velocity_at(two.body, at) - of_other + (free ? 0 : step.length) * gravity;
        moved.col(i) = step.length * (there.linear().transpose() * velocity);
    }
    return moved;
}

double ExplicitBodies::largest_displacement(const SurfacePairs& two, const StepContext& step) const {
    Positions probes(3, 4);
    probes << Vector3d::Zero(), two.radius_of_body() * Matrix3d::Identity();
    probes.colwise() += all[two.body].centre;
    const Positions moved = motion_of(two, step, probes);
    double way = moved.col(0).norm();
    for (int i = 1; i < 4; ++i) way += (moved.col(i) - moved.col(0)).norm();
    return way;
}

double ExplicitBodies::rate_of_surfaces(const StepContext& step) const {
    VectorXd rates = VectorXd::Zero(static_cast<Eigen::Index>(all.size()));
    for (const auto& two : surfaces) {
        const bool free = two->other < all.size();
        const Eigen::Isometry3d there =
            free ? all[two->other].pose() : obstacles[two->other - all.size()].motion.at(step.begin);
        const double stiffness = two->stiffness_within_reach(
            {all[two->body].pose(), there}, step.end(), largest_displacement(*two, step),
            [&](const Positions& points) { return motion_of(*two, step, points); });
        if (stiffness == 0) continue;
        double mobility = largest_mobility(all[two->body], two->radius_of_body());
        if (free) {
            const Positions& points = all[two->other].surface->points;
            mobility += largest_mobility(all[two->other], points.colwise().norm().maxCoeff());
        }
        rates[static_cast<Eigen::Index>(two->body)] += stiffness * mobility;
        if (free) rates[static_cast<Eigen::Index>(two->other)] += stiffness * mobility;
    }
    return rates.size() > 0 ? rates.maxCoeff() : 0;
}

}  // namespace sherd
