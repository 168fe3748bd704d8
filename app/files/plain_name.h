// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace sherd {

/// Returns `name` in a form for file names and for lines of an OBJ file: each ASCII character becomes `_`,
/// except letters, digits, `-` and `.`; bytes of UTF-8 stay. If the result is among the names in `used`,
/// appends a number. Adds the result to `used`.
std::string plain_name(std::string name, std::set<std::string>& used);

}  // namespace sherd
