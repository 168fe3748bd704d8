// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// For a sheet whose toughness depends on the direction: turns the load on a tip from the direction of the
/// largest tension to the direction of the largest G / G_c. In the direction of the largest tension the crack
/// is in pure mode I. An edge that kinks from this direction by an angle a releases the share cos^4(a / 2) of
/// the energy (Cotterell and Rice 1980), so that the intensity is multiplied by cos^2(a / 2).
void turn_to_weakest(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load);

}  // namespace sherd
