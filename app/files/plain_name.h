// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace sherd {

/// Returns a name without characters that a file name or a line of an OBJ file cannot have: they become `_`;
/// bytes of UTF-8 stay. Appends a number if the name is among the `used` ones, and adds it to these.
std::string plain_name(std::string name, std::set<std::string>& used);

}  // namespace sherd
