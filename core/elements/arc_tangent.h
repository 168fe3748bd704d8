// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/lanes.h"

namespace sherd {

/// Tangent below which the arc tangent's series is used: its remainder is below round-off, and it takes a
/// fraction of the time of std::atan2.
inline constexpr double small_tangent = 0.125;

template <class Real>
Real small_arc_tangent(const Real& tangent) {
    const Real s = tangent * tangent, ss = s * s;
    const Real even = ss * (1. / 5 + ss * (1. / 9 + ss * (1. / 13 + ss * (1. / 17))));
    const Real odd = s * (1. / 3 + ss * (1. / 7 + ss * (1. / 11 + ss * (1. / 15))));
    return tangent + tangent * (even - odd);
}

/// Angle of std::atan2(y, x), rad.
inline double arc_tangent(double y, double x) {
    const double tangent = y / x;
    const bool small = x > 0 && tangent * tangent < small_tangent * small_tangent;
    return small ? small_arc_tangent(tangent) : std::atan2(y, x);
}

inline Lanes arc_tangent(const Lanes& y, const Lanes& x) {
    const Lanes tangent = y / x;
    Lanes angle = small_arc_tangent(tangent);
    if (all_less(0, x) && all_less(tangent * tangent, small_tangent * small_tangent)) return angle;
    for (int lane = 0; lane < Lanes::count; ++lane) angle.set(lane, arc_tangent(y[lane], x[lane]));
    return angle;
}

}  // namespace sherd
