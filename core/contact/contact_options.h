// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"

namespace sherd {

struct ContactOptions {
    std::vector<Obstacle> obstacles = {};
    std::vector<RigidBody> bodies = {};  ///< state at the start of the run
    bool sheets = false;                 ///< whether sheets collide with each other and with themselves
    double friction = 0;                 ///< Coulomb coefficient between sheets
    /// Whether implicit steps may follow explicit steps. An explicit step then fails if a pair is too near at
    /// its end for the barrier of implicit steps.
    bool barriers_follow = false;
};

/// State of contact when a stepper begins.
struct ContactStart {
    std::vector<RigidBody> bodies = {};
    std::vector<char> crossed = {};  ///< see surface_pairs()
};

}  // namespace sherd
