// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/bending.h"

namespace sherd {

/// Whether a sheet stays in its rest shape when it is disturbed. Off isometric motions a curved cubic hinge
/// can have less energy than at rest, which the membrane outweighs as long as the sheet is thin beside its
/// edges (stretching stiffness well above bending stiffness, paper, section 8); where it does not, the rest
/// shape blows up. Tested by factoring the stiffness at rest; instabilities that take longer than a tenth of
/// a second to grow are let pass. The form of 2007 is judged as the cubic hinge in equilibrium: its own rest
/// shape is no equilibrium, and where it settles the membrane supplies what that one has built in.
bool stable_at_rest(const Sheet& sheet, BendingModel model = BendingModel::cubic);

}  // namespace sherd
