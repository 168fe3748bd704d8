// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reaction.h"
#include "core/vector.h"

namespace sherd {

/// What contact adds up in one evaluation of an explicit substep.
struct ContactForces {
    Positions force;                  ///< [3, V] N, on the shell
    std::vector<Reaction> obstacles;  ///< of each obstacle, on shell and bodies
    double lost_to_friction = 0;      ///< J, at the velocities of the substep
};

/// A substep that contact forces act in.
struct Substep {
    double length;              ///< s
    const Positions& position;  ///< [3, V] m, at its end
    const Positions& velocity;  ///< [3, V] m/s, in the middle of it
};

}  // namespace sherd
