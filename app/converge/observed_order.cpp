// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/converge/observed_order.h"

#include <cmath>

namespace sherd {

Convergence convergence(const std::array<double, 3>& values) {
    Convergence found{values, {}, {}, {}};
    const double first = values[1] - values[0], second = values[2] - values[1];
    const double ratio = first / second;
    if (!std::isfinite(ratio) || ratio <= 1) return found;
    found.order = std::log2(ratio);
    found.limit = values[2] + second / (ratio - 1);
    if (*found.limit != 0) found.error = values[2] / *found.limit - 1;
    return found;
}

}  // namespace sherd
