// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// Parses a text that is a finite number and nothing else; otherwise none.
std::optional<double> number_of(std::string_view text);

/// Parses the numbers of an option, with commas between them: "1,2.5". Throws Error (input), naming the
/// option, if one of them is not a finite number.
std::vector<double> number_list(const std::string& option, const std::string& text);

}  // namespace sherd
