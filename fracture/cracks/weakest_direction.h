// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Turns the load on a tip from the direction of the largest tension to that of the largest G / G_c, where
/// toughness depends on the direction. In the direction of the largest tension the crack is in pure mode I;
/// an edge that kinks from it by an angle a releases cos^4(a / 2) of the energy (Cotterell and Rice 1980), so
/// that the intensity falls by cos^2(a / 2).
void turn_to_weakest(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load);

}  // namespace sherd
