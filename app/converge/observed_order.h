// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace sherd {

/// Dependence of a result on a length that was halved twice.
struct Convergence {
    std::array<double, 3> values;  ///< with four times the length, twice the length, and the length itself
    /// p, if the differences decrease as length^p: log2 of their ratio. None if they do not decrease, or
    /// change sign.
    std::optional<double> order;
    /// Value for a length of zero by this order (Richardson's extrapolation), and the relative error of the
    /// last value. None without an order.
    std::optional<double> limit, error;
};

Convergence convergence(const std::array<double, 3>& values);

}  // namespace sherd
