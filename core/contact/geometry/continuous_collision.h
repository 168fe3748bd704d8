// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/contact/geometry/distance.h"

namespace sherd {

/// Bound on how much nearer two points of the elements come in a straight motion, m.
double approach(PairKind kind, const PairPositions& displacement);

/// Largest fraction, 0 to 1, of the straight motion from x by `displacement` (m) that two elements can make
/// without coming as near as `minimum` (m). On the way up to it the distance stays above `minimum` by a tenth
/// of what it was, or by `clearance` (m) if that is less, round-off included; 0 where the elements are not
/// apart by more than `minimum` and round-off to begin with, or a number is not finite. By additive
/// continuous collision detection (Li, Kaufman, Jiang 2021, section 4.5): no two points approach faster than
/// a bound, so that time may advance by what is left between them over that bound, again and again. Each time
/// reached is safe, so stopping early, as after many iterations of a grazing pair, is too.
double safe_fraction(PairKind kind, const PairPositions& x, const PairPositions& displacement, double minimum,
                     double clearance = std::numeric_limits<double>::infinity());

}  // namespace sherd
