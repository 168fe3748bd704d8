// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/sheets/sheet_friction.h"

namespace sherd {

/// Friction, N, [3, 4], on the vertices of two elements in contact, in an explicit substep of `length` s. at,
/// velocity: [3, 4] m and m/s, of the vertices. It adds up to no force and no torque. mobility(along): by how
/// many m/s for each N s forces `along` [3, 4] on the vertices, which work on the slip as a unit force does,
/// change the velocity of the slip, 1/kg.
template <class Mobility>
PairPositions pair_friction(const ContactPair& pair, const PairPositions& at, const PairPositions& velocity,
                            double coefficient, double length, Mobility mobility) {
    if (coefficient == 0) return PairPositions::Zero();
    const SlidingPair sliding = sliding_pair(pair, at, coefficient, length);
    const Vector3d slip = sliding.slip * velocity.reshaped();
    if (slip.isZero(0)) return PairPositions::Zero();
    const PairPositions along = (sliding.slip.transpose() * slip.normalized()).reshaped(3, 4);
    const Vector3d rubbed = explicit_friction(sliding.friction.limit, slip, 1 / mobility(along), length);
    return -rubbed.norm() * along;
}

}  // namespace sherd
