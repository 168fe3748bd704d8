// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace sherd {

/// A check for CLI::Option::check: returns the error for the text that an option was given, or nothing.
using NumberCheck = std::function<std::string(const std::string&)>;

/// A whole number, all of the text.
NumberCheck whole_number(std::int64_t least, std::int64_t most = std::numeric_limits<std::int32_t>::max());
/// A finite number, all of the text, from `least` to `most`.
NumberCheck number_within(double least, double most);
/// A finite number of 0 or more.
NumberCheck not_negative_number();
/// A finite number above 0.
NumberCheck positive_number();

}  // namespace sherd
