// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Splits a text at each separator; parts may be empty.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace sherd
