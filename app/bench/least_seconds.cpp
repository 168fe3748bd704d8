// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/least_seconds.h"

#include <algorithm>
#include <ctime>
#include <limits>

namespace sherd {

double least_seconds(const std::function<void()>& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds_of_least_seconds; ++i) {
        const std::clock_t start = std::clock();
        work();
        least = std::min(least, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return least;
}

}  // namespace sherd
