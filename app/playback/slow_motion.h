// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace sherd {

/// How fast a run is shown.
struct SlowMotion {
    std::optional<double> factor;  ///< how many times slower than reality; none: default_slowdown()
    std::optional<double> rate;    ///< pictures a second of what is shown; none: default_rate
};

inline constexpr double default_rate = 24;

/// Throws Error (input) on values that make no sense.
void check_slow_motion(const SlowMotion& motion);

/// How fast a run of so many seconds is shown.
struct Pace {
    double seconds = 0;  ///< of the run
    double slowdown = 1;
    double rate = default_rate;  ///< 1/s

    double step() const { return 1 / (slowdown * rate); }  ///< s of the run from picture to picture
    std::string words() const;  ///< "200 times slower than reality: 0.03 s last 6 s"
};

Pace pace_of(const SlowMotion& motion, double seconds);

/// The smallest factor of 1, 2, 5, 10, 20, ... that makes a run of so many seconds last 4 s; it is over after
/// 10 s then. 1 when it lasts longer by itself, or no time at all.
double default_slowdown(double seconds);

}  // namespace sherd
