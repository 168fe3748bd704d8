// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/contact/geometry/distance.h"

namespace sherd {

/// Bound, m, on how much the distance of two elements can decrease in a straight motion.
double approach(PairKind kind, const PairPositions& displacement);

/// Whether safe_fraction() is 1 for any two elements that are at least `distance` apart and approach each
/// other by at most `way`, m. The caller allows for round-off in both.
bool surely_free(double distance, double way, double minimum, double clearance);

/// Largest fraction, 0 to 1, of the straight motion from x by `displacement` (m) that two elements can make
/// while their distance stays above `minimum` (m). Up to that fraction the distance exceeds `minimum` by a
/// tenth of the initial excess, or by `clearance` (m) if that is less, round-off included. Returns 0 if the
/// distance does not exceed `minimum` by more than round-off at the start, or a number is not finite. The
/// method is additive continuous collision detection (Li, Kaufman, Jiang 2021, section 4.5): no two points
/// approach faster than a bound, so time may repeatedly advance by the remaining distance over that bound.
/// Each time reached is safe, so it is also safe to stop early, as after many iterations of a grazing pair.
double safe_fraction(PairKind kind, const PairPositions& x, const PairPositions& displacement, double minimum,
                     double clearance = std::numeric_limits<double>::infinity());

}  // namespace sherd
