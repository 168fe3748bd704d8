// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace sherd {

/// A name in which all that a file's name or a line of an OBJ cannot have is `_`; bytes of UTF-8 stay. It
/// gets a number if it is among the `used` ones, and is one of them afterwards.
std::string plain_name(std::string name, std::set<std::string>& used);

}  // namespace sherd
