// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/contact/sheets/sheet_friction.h"
#include "core/reaction.h"
#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// Returns the friction, N, [3, 4], on the vertices of two elements in contact, in an explicit substep of
/// `length` s; its sum and its torque are zero. at: [3, 4] m, positions of the vertices; velocity: [3, 4]
/// m/s, their velocities; coefficient: Coulomb coefficient. mobility(along): returns the change of the slip's
/// velocity per impulse, 1/kg, where a unit force against the slip is distributed to the vertices as the
/// forces `along`, [3, 4].
template <class Mobility>
PairPositions pair_friction(const ContactPair& pair, const PairPositions& at, const PairPositions& velocity,
                            double coefficient, double length, Mobility mobility) {
    if (coefficient == 0) return PairPositions::Zero();
    const SlidingPair sliding = sliding_pair(pair, at, coefficient, length);
    const Vector3d slip = sliding.slip * velocity.reshaped();
    if (slip.isZero(0)) return PairPositions::Zero();
    const PairPositions along = (sliding.slip.transpose() * slip.normalized()).reshaped(3, 4);
    const Vector3d friction_force =
        explicit_friction(sliding.friction.limit, slip, 1 / mobility(along), length);
    return -friction_force.norm() * along;
}

/// Mean velocity, m/s, of a point of a rigid collider that moves from the pose `before` to the pose `now` in
/// `length` s. at: m, position of the point at the pose `now`.
inline Vector3d velocity_of_point(const Eigen::Isometry3d& before, const Eigen::Isometry3d& now,
                                  const Vector3d& at, double length) {
    return (at - before * (now.inverse() * at)) / length;
}

/// Forces of contact in one substep of an explicit step.
struct ContactForces {
    Positions force;                  ///< [3, V] N, forces on the vertices of the shell
    std::vector<Reaction> obstacles;  ///< forces of each obstacle on the shell and the bodies
    /// Forces, N, [3, S], on the vertices of colliders; without columns if no collider deforms.
    Positions deforming;
    // The parts of `force`, `obstacles` and `deforming` that friction causes:
    Positions friction;
    std::vector<Reaction> obstacle_friction;
    Positions deforming_friction;
    std::vector<Index> vertices;  ///< vertices of the shell whose forces may differ from zero

    void visit_state(StateVisitor& visit) {
        auto& [force, obstacles, deforming, friction, obstacle_friction, deforming_friction, vertices] =
            *this;
        visit(force, obstacles, deforming, friction, obstacle_friction, deforming_friction, vertices);
    }

    /// Sets all forces to zero. count: number of the shell's vertices; some: vertices on which forces may act
    /// from now on; of_colliders: number of the colliders' vertices, or 0 if no collider deforms.
    void clear(Eigen::Index count, std::span<const Index> some, std::size_t number_of_obstacles,
               Eigen::Index of_colliders) {
        deforming.setZero(3, of_colliders);
        deforming_friction.setZero(3, of_colliders);
        obstacles.assign(number_of_obstacles, {});
        obstacle_friction.assign(number_of_obstacles, {});
        if (force.cols() != count) {
            force.setZero(3, count);
            friction.setZero(3, count);
        } else {
            for (const Index v : vertices) force.col(v) = friction.col(v) = Vector3d::Zero();
        }
        vertices.assign(some.begin(), some.end());
    }
    /// Adds a friction force (N) that an obstacle exerts at the point `at` (m).
    void add_friction(std::size_t obstacle, const Vector3d& at, const Vector3d& friction_force) {
        obstacles[obstacle].add(at, friction_force);
        obstacle_friction[obstacle].add(at, friction_force);
    }
    /// Adds a force (N) on a vertex of colliders. add_collider_friction() adds the force to the friction,
    /// too.
    void add_collider_force(Index vertex, const Vector3d& contact_force) {
        if (deforming.cols() > 0) deforming.col(vertex) += contact_force;
    }
    void add_collider_friction(Index vertex, const Vector3d& friction_force) {
        add_collider_force(vertex, friction_force);
        if (deforming.cols() > 0) deforming_friction.col(vertex) += friction_force;
    }
    /// Adds a friction force (N) on a vertex of the shell.
    void add_friction(Index vertex, const Vector3d& friction_force) {
        force.col(vertex) += friction_force;
        friction.col(vertex) += friction_force;
    }
};

/// Upper bounds on the squares of the frequencies, 1/s^2, that contact adds in a step.
struct ContactRates {
    VectorXd of_vertices;  ///< [V] bounds; 0: the vertex meets nothing
    double of_bodies = 0;  ///< bound for all bodies
};

/// A substep of an explicit step, and the shell's motion in it.
struct Substep {
    double length;              ///< s
    const Positions& position;  ///< [3, V] m, at the end of the substep
    const Positions& velocity;  ///< [3, V] m/s, in the middle of the substep
};

/// Returns the means of the reactions at the same index.
inline std::vector<Reaction> means(std::vector<Reaction> some, std::span<const Reaction> others) {
    for (std::size_t i = 0; i < some.size(); ++i) {
        some[i].force = 0.5 * (some[i].force + others[i].force);
        some[i].moment = 0.5 * (some[i].moment + others[i].moment);
    }
    return some;
}

}  // namespace sherd
