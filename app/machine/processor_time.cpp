// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machine/processor_time.h"

#include <algorithm>
#include <ctime>
#include <limits>

namespace sherd {

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double least_seconds(const std::function<void()>& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < rounds_of_least_seconds; ++i) {
        const double start = processor_seconds();
        work();
        least = std::min(least, processor_seconds() - start);
    }
    return least;
}

}  // namespace sherd
