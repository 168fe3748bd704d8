// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sherd {

/// A mean, and its 95 % confidence interval.
struct MeanEstimate {
    std::size_t count = 0;               ///< number of finite values
    double mean = 0, low = 0, high = 0;  ///< mean, and ends of the interval: all NaN without values; with one
                                         ///< value the interval is NaN
};

/// Returns the mean of the finite values, and its interval by the bootstrap (Efron 1979): from 2.5 to 97.5 %
/// of the means of 2000 samples that are drawn from the values with replacement. Equal values give equal
/// intervals.
MeanEstimate estimated_mean(std::span<const double> values);

}  // namespace sherd
