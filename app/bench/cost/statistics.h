// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Median of at least one number.
double median(std::vector<double> numbers);

/// The exponent p of the power law y = c x^p that fits points (x, y) of positive numbers best, by least
/// squares of logarithms. At least two points must differ in x.
double fitted_exponent(std::span<const Vector2d> points);

}  // namespace sherd
