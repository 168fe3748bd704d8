// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd::test {

/// Of four vertices two, the second and the third, that are held together along x by a force, N: [3, 4].
inline Positions held_together(double force) {
    Positions kept = Positions::Zero(3, 4);
    kept(0, 1) = force;
    kept(0, 2) = -force;
    return kept;
}

/// How they move apart by `way`, m: [3, 4].
inline Positions parted_by(double way) {
    return -0.5 * way * held_together(1);
}

}  // namespace sherd::test
