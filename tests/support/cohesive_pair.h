// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd::test {

/// Forces [3, 4] that hold the second and the third of four vertices together along x, each by `force`, N.
inline Positions cohesive_pair(double force) {
    Positions kept = Positions::Zero(3, 4);
    kept(0, 1) = force;
    kept(0, 2) = -force;
    return kept;
}

/// Displacements [3, 4] that move these two vertices apart by `way`, m.
inline Positions opening_displacement(double way) {
    return -0.5 * way * cohesive_pair(1);
}

}  // namespace sherd::test
