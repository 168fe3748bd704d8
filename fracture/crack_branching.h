// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "fracture/breakable_shell.h"
#include "fracture/growing_tip.h"

namespace sherd {

// A tip that runs at its speed limit and is fed twice what it needs branches: it goes on in two ways at once.
// From then on these are two tips, twins. As long as they are within a few edges of each other, a mesh does
// not tell which of them bears more, and what it tells by chance would decide, since the first to go on
// unloads the other one. So twins that are near go on together, by the mean of what they bear, or not at all.

/// Lets the mean release of a tip follow what it bore for the last `waited` s: its intensity over the
/// toughness.
void feed(const BreakableShell& shell, GrowingTip& tip, const TipLoad& load, double intensity_ratio,
          double waited);

/// Whether a tip that goes on at `time` (s) does so in two ways; all: the tips that there are.
bool branches(const BreakableShell& shell, const GrowingTip& tip, const TipLoad& load,
              std::span<const GrowingTip> all, double time);

/// The two directions of a tip that branches about a direction, unit vectors in the tangent plane.
std::array<Vector3d, 2> branch_directions(const BreakableShell& shell, const GrowingTip& tip,
                                          const Vector3d& direction);

/// The twin of a tip, one of `all`, as long as they go on together; else null.
const GrowingTip* near_twin(const BreakableShell& shell, const GrowingTip& tip,
                            std::span<const GrowingTip> all);

}  // namespace sherd
