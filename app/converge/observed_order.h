// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace sherd {

/// Dependence of a result on a length that was halved twice.
struct Convergence {
    std::array<double, 3> values;  ///< with four times the length, twice the length, and the length itself
    /// Order p: differences between the values that follow each other decrease as length^p, so that p is log2
    /// of their ratio. None if the differences do not decrease, or change sign.
    std::optional<double> order;
    /// Value for a length of zero according to this order (Richardson's extrapolation), and the relative
    /// error of values[2]. None without an order; there is no error if the limit is 0.
    std::optional<double> limit, error;
};

Convergence convergence(const std::array<double, 3>& values);

}  // namespace sherd
