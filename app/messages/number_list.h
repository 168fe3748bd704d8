// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// Returns the number in `text`, which must be a finite number and nothing else; otherwise returns none.
std::optional<double> number_of(std::string_view text);

/// Returns the numbers in `text`, the value of an option, which are separated by commas: "1,2.5". Throws
/// Error (input), naming the option, if one of them is not a finite number.
std::vector<double> number_list(const std::string& option, const std::string& text);

}  // namespace sherd
