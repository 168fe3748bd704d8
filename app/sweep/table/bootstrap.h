// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sherd {

/// A mean, and its confidence interval, 95 %.
struct MeanEstimate {
    std::size_t count = 0;               ///< number of finite values
    double mean = 0, low = 0, high = 0;  ///< NaN without values; with one value the interval is NaN
};

/// Estimates the mean, and its interval by the bootstrap (Efron 1979): from 2.5 to 97.5 % of the means of
/// 2000 samples that are drawn from the values with replacement. Equal values have equal intervals.
MeanEstimate estimated_mean(std::span<const double> values);

}  // namespace sherd
