// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace sherd {

/// Requested speed at which a run is shown.
struct SlowMotion {
    std::optional<double> factor;  ///< how many times slower than reality; none: default_slowdown()
    std::optional<double> rate;    ///< pictures per second of the film; none: default_rate
};

inline constexpr double default_rate = 24;  ///< pictures per second of a film

/// Throws Error (input) if the factor is not positive and finite, or the rate is outside 0.1 to 1000.
void check_slow_motion(const SlowMotion& motion);

/// Speed at which a run is shown.
struct Pace {
    double seconds = 0;          ///< s, simulated time of the run
    double slowdown = 1;         ///< how many times slower than reality
    double rate = default_rate;  ///< pictures per second of the film

    double step() const { return 1 / (slowdown * rate); }  ///< s, simulated time between two pictures
    std::string words() const;  ///< "200 times slower than reality: 0.03 s last 6 s"
};

Pace pace_of(const SlowMotion& motion, double seconds);

/// Returns the smallest of the factors 1, 2, 5, 10, 20, ... by which a run of so many seconds of simulated
/// time must be slowed down to last 4 s or more; if slowed down, it then lasts at most 10 s. Returns 1 if the
/// run has no duration.
double default_slowdown(double seconds);

}  // namespace sherd
