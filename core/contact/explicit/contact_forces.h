// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reaction.h"
#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// What contact adds up in one evaluation of an explicit substep.
struct ContactForces {
    Positions force;                  ///< [3, V] N, on the shell
    std::vector<Reaction> obstacles;  ///< of each obstacle, on shell and bodies
    // What of these is friction:
    Positions friction;
    std::vector<Reaction> obstacle_friction;

    void visit_state(StateVisitor& visit) {
        auto& [force, obstacles, friction, obstacle_friction] = *this;
        visit(force, obstacles, friction, obstacle_friction);
    }

    /// Makes all of it zero.
    void clear(Eigen::Index vertices, std::size_t number_of_obstacles) {
        force.setZero(3, vertices);
        friction.setZero(3, vertices);
        obstacles.assign(number_of_obstacles, {});
        obstacle_friction.assign(number_of_obstacles, {});
    }
    /// Adds friction that an obstacle exerts at a point (m), N.
    void rub(std::size_t obstacle, const Vector3d& at, const Vector3d& rubbed) {
        obstacles[obstacle].add(at, rubbed);
        obstacle_friction[obstacle].add(at, rubbed);
    }
    /// Adds friction on a vertex of the shell.
    void rub(Index vertex, const Vector3d& rubbed) {
        force.col(vertex) += rubbed;
        friction.col(vertex) += rubbed;
    }
};

/// A substep that contact forces act in.
struct Substep {
    double length;              ///< s
    const Positions& position;  ///< [3, V] m, at its end
    const Positions& velocity;  ///< [3, V] m/s, in the middle of it
};

}  // namespace sherd
