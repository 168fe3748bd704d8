// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/damping.h"

namespace sherd {

/// The longest substep of central differences to take, s: a share of the longest stable one. highest: rad/s,
/// angular frequency of what swings fastest. Throws std::runtime_error when a step of `step` (s) would need
/// more than a million of them, or when it is not a number because positions have run away.
double stable_substep(double highest, const Damping& damping, double step);

/// Throws std::runtime_error, which says that explicit steps have become unstable, unless they are stable.
void require_stable(bool is_stable);

}  // namespace sherd
