// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

namespace sherd {

/// Power law N(> x) ~ x^-exponent of the number of values larger than x.
struct PowerLaw {
    double exponent = 0;
    std::array<double, 2> interval{};  ///< confidence interval of the exponent, 95 %
    std::size_t count = 0;             ///< number of values that were fitted
};

/// Fits the law to the values above `from` > 0, by maximum likelihood (Hill 1975; Clauset, Shalizi and Newman
/// 2009, eq. 3.1, whose alpha is the exponent plus 1), with the exact interval of its gamma distribution.
/// None for fewer than two values.
std::optional<PowerLaw> power_law(std::span<const double> values, double from);

}  // namespace sherd
