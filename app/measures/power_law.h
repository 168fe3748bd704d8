// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

namespace sherd {

/// N(> x) ~ x^-exponent: how many of a collection are larger than x.
struct PowerLaw {
    double exponent = 0;
    std::array<double, 2> interval{};  ///< has the exponent in 95 of 100 such collections
    std::size_t count = 0;             ///< of values that it was made of
};

/// The law by maximum likelihood (Hill 1975; Clauset, Shalizi and Newman 2009, eq. 3.1, whose alpha is the
/// exponent plus 1) of the values above `from` > 0, with the exact interval of its gamma distribution.
/// Nothing of fewer than two.
std::optional<PowerLaw> power_law(std::span<const double> values, double from);

}  // namespace sherd
