// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "core/contact/geometry/distance.h"

namespace sherd {

/// Upper bound, m, on the decrease of the distance of two elements in a straight motion by `displacement`
/// (m).
double approach(PairKind kind, const PairPositions& displacement);

/// Whether safe_fraction() with this `minimum` and `clearance` is certain to be 1 for two elements that are
/// at least `distance` apart and approach each other by at most `way`; all in m. The caller must include
/// round-off in `distance` and `way`.
bool surely_free(double distance, double way, double minimum, double clearance);

/// A fraction, 0 to 1, of the straight motion from x by `displacement` (m) that two elements can make while
/// their distance stays above `minimum` (m). Up to that fraction, round-off included, the distance exceeds
/// `minimum` by a tenth of its excess at x, or by `clearance` (m) if that is less. Returns 0 if the distance
/// at x does not exceed `minimum` by more than round-off, or if a number is not finite. The method is
/// additive continuous collision detection (Li, Kaufman, Jiang 2021, section 4.5): no two points approach
/// faster than a bound, so time may repeatedly advance by the remaining distance over that bound. The motion
/// is safe up to each time reached; therefore the iteration may stop before the largest safe fraction, and
/// does so after many iterations, as for a grazing pair.
double safe_fraction(PairKind kind, const PairPositions& x, const PairPositions& displacement, double minimum,
                     double clearance = std::numeric_limits<double>::infinity());

}  // namespace sherd
