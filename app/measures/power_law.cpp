// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/power_law.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace sherd {

std::optional<PowerLaw> power_law(std::span<const double> values, double from) {
    double logarithms = 0;
    PowerLaw law;
    for (const double value : values) {
        if (value <= from) continue;
        logarithms += std::log(value / from);
        ++law.count;
    }
    if (law.count < 2) return std::nullopt;
    const auto count = static_cast<double>(law.count);
    law.exponent = count / logarithms;
    // Twice the sum of the logarithms times the true exponent has a chi-squared distribution with two degrees
    // of freedom for each value.
    const boost::math::chi_squared distribution(2 * count);
    const double once = law.exponent / (2 * count);
    law.interval = {once * quantile(distribution, 0.025), once * quantile(distribution, 0.975)};
    return law;
}

}  // namespace sherd
