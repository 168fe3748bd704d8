// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace sherd {

/// A check for CLI::Option::check: returns the error for the text given to an option, or an empty string.
using NumberCheck = std::function<std::string(const std::string&)>;

/// Accepts text that is a whole number from `least` to `most`.
NumberCheck whole_number(std::int64_t least, std::int64_t most = std::numeric_limits<std::int32_t>::max());
/// Accepts text that is a finite number from `least` to `most`.
NumberCheck number_within(double least, double most);
/// Accepts a finite number of 0 or more.
NumberCheck not_negative_number();
/// Accepts a finite number above 0.
NumberCheck positive_number();

}  // namespace sherd
