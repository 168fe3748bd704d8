// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

namespace sherd {

/// Range of finite numbers.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool with_least = false, with_most = false;  ///< whether the bounds themselves are allowed

    constexpr bool contains(double x) const {
        return (with_least ? x >= least : x > least) && (with_most ? x <= most : x < most);
    }
    bool has_least() const { return least > -std::numeric_limits<double>::infinity(); }
    bool has_most() const { return most < std::numeric_limits<double>::infinity(); }
    /// Returns a description for messages, such as "a positive number".
    std::string words() const;
};
inline constexpr Range any_number{};
inline constexpr Range positive{.least = 0};
inline constexpr Range not_negative{.least = 0, .with_least = true};

}  // namespace sherd
