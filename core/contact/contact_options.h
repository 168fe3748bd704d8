// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"

namespace sherd {

struct ContactOptions {
    std::vector<Obstacle> obstacles = {};
    std::vector<RigidBody> bodies = {};  ///< at the start of the run
    bool sheets = false;                 ///< whether sheets collide with each other and with themselves
    double friction = 0;                 ///< Coulomb coefficient between sheets
    /// Whether implicit steps may follow explicit ones, which then fail where a pair gets too near for a
    /// barrier.
    bool barriers_follow = false;
};

/// State of contact where a stepper begins.
struct ContactStart {
    std::vector<RigidBody> bodies = {};
    std::vector<char> crossed = {};  ///< see surface_pairs()
};

}  // namespace sherd
