// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// A unit with a prefix that makes numbers short.
struct UnitPrefix {
    double factor;  ///< from the SI unit, for numbers between 1 and 1000
    std::string unit;
};

/// The SI unit with the prefix that suits the largest number; plain numbers and 1/m stay as they are.
UnitPrefix prefixed(const std::string& unit, double largest);

/// Round numbers that divide [low, high], about `most` at most and at least two.
std::vector<double> round_ticks(double low, double high, int most, bool whole);

/// Round numbers within [low, high], low > 0, on a logarithmic axis: 1, 2, 5, 10 and so on, or powers of ten
/// alone.
std::vector<double> logarithmic_ticks(double low, double high);

/// Label of a tick.
std::string tick_text(double tick);

}  // namespace sherd
