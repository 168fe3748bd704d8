// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solver/potential.h"

namespace sherd {

/// Changes the last correction of a step so that each loose piece, or pieces in contact with each other
/// together, keep their linear momentum, less the loss by mass damping; an approximate inverse Hessian does
/// not keep it. Pieces that are held, or touch an obstacle or a body, or would move by more than `tolerance`
/// (m), are left as they are. gradient: N, at x.
void conserve_momentum(const Potential& potential, const Positions& x, const Positions& gradient,
                       double tolerance, Positions& correction);

}  // namespace sherd
