// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// The time (s) in which a tip advances by one edge at its speed limit: the mean length of a sheet's edges at
/// rest over its limit, the least of all sheets that have a toughness. Longer implicit steps advance a crack
/// by several edges in stages; longer explicit ones, which evaluate cracks once, slow it down. Nothing where
/// no sheet has a toughness.
std::optional<double> resolving_step(const BreakableShell& shell);

}  // namespace sherd
