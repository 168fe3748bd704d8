// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Numbers with commas between them, as an option has them: "1,2.5". Throws Error (input), naming the option,
/// when one of them is none.
std::vector<double> number_list(const std::string& option, const std::string& text);

}  // namespace sherd
