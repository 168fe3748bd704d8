// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/surface_stress.h"

namespace sherd {

/// Mean length at rest, m, of the edges ahead of a tip; 0 if there are none.
double edge_length_ahead(const BreakableShell& shell, const GrowingTip& tip);

/// Largest angle, rad, by which a running tip may turn with its next edge; without this limit waves would
/// make the path snake.
double largest_tip_turn(const BreakableShell& shell, const GrowingTip& tip);

/// Load on a tip by the surface stress averaged over the faces ahead of it. Let s_m and s_b be the mean, and
/// half the difference, of the stresses across the crack at the two surfaces. Then K = sqrt(max(s_m, 0)^2 + c
/// s_b^2) sqrt(2 pi alpha h), with c = (1 + nu) / (3 (3 + nu)) (energy release in bending, Hui and Zehnder
/// 1993), the length h of the edges ahead, and a measured number alpha. The tip turns to the direction of the
/// largest hoop stress (Erdogan and Sih 1963) of the surface under the larger tension. A tip that runs, or is
/// mainly in bending, turns no further than largest_tip_turn(). Used where TipEnergy gives no load, as in
/// explicit steps, in which the energy of fast plates oscillates, and with hinges that are not coupled.
TipLoad load_by_stress(const BreakableShell& shell, const GrowingTip& tip, const FaceStrains& strains);

}  // namespace sherd
