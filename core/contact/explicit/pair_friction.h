// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/sheets/sheet_friction.h"

namespace sherd {

/// Friction, N, [3, 4], on the vertices of two elements in contact, in an explicit substep of `length` s. at,
/// velocity: [3, 4] m and m/s, of the vertices. It has no net force and no net torque. mobility(along):
/// change of the slip's velocity per impulse, 1/kg, by forces `along` [3, 4] on the vertices that do the work
/// of a unit force on the slip.
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

}  // namespace sherd
