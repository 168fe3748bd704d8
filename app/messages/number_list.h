// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Parses the numbers of an option, with commas between them: "1,2.5". Throws Error (input), naming the
/// option, if one of them is not a finite number.
std::vector<double> number_list(const std::string& option, const std::string& text);

}  // namespace sherd
