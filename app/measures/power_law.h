// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

namespace sherd {

/// Power law N(> x) ~ x^-exponent of the number of values larger than x.
struct PowerLaw {
    double exponent = 0;
    std::array<double, 2> interval{};  ///< 95 % confidence interval of the exponent
    std::size_t count = 0;             ///< number of values that were fitted
};

/// Fits the law by maximum likelihood to the values that are larger than `from`, which is positive (Hill
/// 1975; Clauset, Shalizi and Newman 2009, eq. 3.1, whose alpha is the exponent plus 1). The confidence
/// interval is exact, since the distribution of the estimate is known. Returns none for fewer than two such
/// values.
std::optional<PowerLaw> power_law(std::span<const double> values, double from);

}  // namespace sherd
