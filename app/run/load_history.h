// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

namespace sherd {

/// The load factors of a run's steps, in their order.
struct LoadHistory {
    double last = 0, largest = 0;
    std::optional<double> limit = {};  ///< at which the load fell for the first time; none: it never did

    void add(double load) {
        if (!limit && load < last) limit = last;
        last = load;
        largest = std::max(largest, load);
    }
};

}  // namespace sherd
