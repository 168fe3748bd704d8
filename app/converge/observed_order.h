// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

namespace sherd {

/// How a result depends on a length that was halved twice.
struct Convergence {
    std::array<double, 3> values;  ///< with four times the length, with twice, with the length itself
    /// p, if the differences fall like length^p: log2 of their ratio. None: they do not fall, or change sign.
    std::optional<double> order;
    /// The value for a length of zero by this order (Richardson's extrapolation), and by how much the last
    /// value is off from it, as a part of it. Without an order there is neither.
    std::optional<double> limit, error;
};

Convergence convergence(const std::array<double, 3>& values);

}  // namespace sherd
