// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/damping.h"

namespace sherd {

/// Returns the longest substep of central differences to take, s: `share` of the critical time step. highest:
/// rad/s, the highest angular frequency. Throws std::runtime_error if a step of `step` (s) would need more
/// than a million substeps, or if the result is not a number because positions have diverged.
double stable_substep(double highest, const Damping& damping, double step, double share);

/// Throws std::runtime_error, which says that explicit steps have become unstable, unless `is_stable`.
void require_stable(bool is_stable);

/// Number of substeps of at most `longest` s in `duration` s.
int substeps_of(double duration, double longest);

}  // namespace sherd
