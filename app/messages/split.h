// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// Returns the parts of a text between separators; parts may be empty.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace sherd
