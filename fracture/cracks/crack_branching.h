// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "fracture/cracks/growing_tip.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

// A tip that runs at its speed limit with a release rate of twice the fracture energy branches: it propagates
// in two directions at once. From then on there are two tips, its branches. While the two are within a few
// edges of each other, the mesh does not resolve which of them has the larger load, and chance would decide,
// since the branch that propagates first unloads the other. Branches that are near each other therefore
// propagate together, if the root mean square of their ratios of intensity to toughness exceeds 1, or not at
// all.

/// Updates the mean release of a tip (GrowingTip::release) with the load that it has borne during the last
/// `waited` s. intensity_ratio: intensity of the load over toughness.
void update_mean_release(const BreakableShell& shell, GrowingTip& tip, const TipLoad& load,
                         double intensity_ratio, double waited);

/// Whether a tip that propagates at `time` (s) branches. all: all tips.
bool branches(const BreakableShell& shell, const GrowingTip& tip, const TipLoad& load,
              std::span<const GrowingTip> all, double time);

/// The directions of the two branches of a tip, unit vectors in the tangent plane, one on each side of
/// `direction`.
std::array<Vector3d, 2> branch_directions(const BreakableShell& shell, const GrowingTip& tip,
                                          const Vector3d& direction);

/// The other branch of a tip, an element of `all`, while the two are so near each other that they propagate
/// together; else null.
const GrowingTip* near_branch(const BreakableShell& shell, const GrowingTip& tip,
                              std::span<const GrowingTip> all);

}  // namespace sherd
