// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/breakable_shell.h"

namespace sherd {

/// The time (s) in which a tip goes on by an edge at its speed limit: the mean length of a sheet's edges at
/// rest over its limit, the least of the sheets that have a toughness. Implicit steps that are longer stage
/// several edges of one crack; explicit ones, which judge once, hold it back. Nothing where no sheet has one.
std::optional<double> resolving_step(const BreakableShell& shell);

}  // namespace sherd
