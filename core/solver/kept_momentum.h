// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solver/potential.h"

namespace sherd {

/// Makes the last correction of a step keep the linear momentum of each loose piece, or of pieces that touch
/// each other together, less what damping of mass takes, which an approximate inverse Hessian does not. What
/// is held, or touches an obstacle or a body, is left alone, and so is what would move by more than
/// `tolerance` (m). gradient: N, at x.
void keep_momentum(const Potential& potential, const Positions& x, const Positions& gradient,
                   double tolerance, Positions& correction);

}  // namespace sherd
