// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

/// Mean length, m, of the edges ahead of a tip at rest; 0 if there are none.
double edge_length_ahead(const BreakableShell& shell, const GrowingTip& tip);

/// Largest angle, rad, by which a running tip may turn with its next edge; without it waves would make the
/// path snake.
double largest_tip_turn(const BreakableShell& shell, const GrowingTip& tip);

/// Load on a tip by the surface stress averaged over the faces ahead of it: with the mean s_m and half the
/// difference s_b of the surfaces' stress across the crack, K = sqrt(max(s_m, 0)^2 + c s_b^2) sqrt(2 pi alpha
/// h), with c = (1 + nu) / (3 (3 + nu)) (energy release in bending, Hui and Zehnder 1993), h the length of
/// the edges ahead and alpha from measured tips. The tip turns to the largest hoop stress (Erdogan and Sih
/// 1963) of the surface under the larger tension; if it runs, and in bending, not faster than on a radius of
/// 20 thicknesses. Used where TipEnergy is not: in fast plates, where the energy oscillates, and with hinges
/// that are not coupled.
TipLoad load_by_stress(const BreakableShell& shell, const GrowingTip& tip, const FaceStrains& strains);

}  // namespace sherd
