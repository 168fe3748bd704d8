// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sherd {

/// A mean, and an interval that has the mean of all there could be in 95 of 100 cases.
struct MeanEstimate {
    std::size_t count = 0;               ///< of values; NaN is none
    double mean = 0, low = 0, high = 0;  ///< NaN where there is none; of one value the interval is NaN
};

/// The interval by the bootstrap (Efron 1979): from 2.5 to 97.5 % of the means of 2000 samples that are drawn
/// from the values with replacement. The same values have the same interval.
MeanEstimate estimated_mean(std::span<const double> values);

}  // namespace sherd
