// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// A unit with a prefix that makes numbers short.
struct UnitPrefix {
    double factor;  ///< converts from the SI unit
    std::string unit;
};

/// Returns the SI unit `unit` with the prefix for which `largest`, the largest value, becomes a short number.
/// Plain numbers, whose unit is empty, and 1/m get no prefix.
UnitPrefix prefixed(const std::string& unit, double largest);

/// Returns equally spaced round numbers in [low, high]: at most about `most` of them, and at least two, of
/// which the second may then lie beyond `high`. whole: whether all must be whole numbers.
std::vector<double> round_ticks(double low, double high, int most, bool whole);

/// Returns round numbers in [low, high], low > 0, for a logarithmic axis: 1, 2, 5, 10, 20 and so on, or, if
/// the range is wide, only powers of ten.
std::vector<double> logarithmic_ticks(double low, double high);

/// Returns the label of a tick.
std::string tick_text(double tick);

}  // namespace sherd
