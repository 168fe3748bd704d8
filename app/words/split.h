// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sherd {

/// What stands between the separators of a text, before the first and after the last, which may be empty.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace sherd
