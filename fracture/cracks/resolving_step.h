// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Returns the time, s, in which a tip advances by one edge at its speed limit: the mean length of a sheet's
/// edges at rest over the sheet's speed limit, for the sheet with a toughness where it is least. Returns
/// nothing if no sheet has a toughness. In a longer implicit step a crack advances by several edges, in
/// stages; longer explicit steps, in which cracks are evaluated once, slow it down.
std::optional<double> resolving_step(const BreakableShell& shell);

}  // namespace sherd
