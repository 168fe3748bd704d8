// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>

namespace sherd {

/// Last, largest and limit load factor of a run's steps.
struct LoadHistory {
    double last = 0, largest = 0;
    std::optional<double> limit = {};  ///< load factor before its first decrease; none: it never decreased

    void add(double load) {
        if (!limit && load < last) limit = last;
        last = load;
        largest = std::max(largest, load);
    }
};

}  // namespace sherd
