// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/slow_motion.h"

#include <fmt/format.h>

#include <cmath>

#include "meshops/error.h"

namespace sherd {

void check_slow_motion(const SlowMotion& motion) {
    constexpr double least_rate = 0.1, most_rate = 1000;
    if (motion.factor && !(*motion.factor > 0 && std::isfinite(*motion.factor)))
        throw Error(fmt::format("--slow {}: give how many times slower than reality, above 0; 1 is real time",
                                *motion.factor));
    if (motion.rate && !(*motion.rate >= least_rate && *motion.rate <= most_rate))
        throw Error(fmt::format("--rate {}: give pictures per second, {} to {}", *motion.rate, least_rate,
                                most_rate));
}

double default_slowdown(double seconds) {
    constexpr double shortest = 4 * (1 - 1e-9);  // s, reduced for round-off: 0.04 s times 100 counts as 4 s
    if (!(seconds > 0)) return 1;
    for (double decade = 1; std::isfinite(decade); decade *= 10)
        for (const double digit : {1.0, 2.0, 5.0})
            if (seconds * digit * decade >= shortest) return digit * decade;
    return 1;
}

Pace pace_of(const SlowMotion& motion, double seconds) {
    return {seconds, motion.factor.value_or(default_slowdown(seconds)), motion.rate.value_or(default_rate)};
}

std::string Pace::words() const {
    const std::string pace = slowdown == 1  ? "in real time"
                             : slowdown > 1 ? fmt::format("{:g} times slower than reality", slowdown)
                                            : fmt::format("{:g} times faster than reality", 1 / slowdown);
    return fmt::format("{}: {:.4g} s last {:.4g} s", pace, seconds, seconds * slowdown);
}

}  // namespace sherd
