// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// Returns where the comment of a line of an OBJ or MTL file begins; npos: it has none. A `#` begins one, but
/// in a name only as a word alone, or in front of a word that is not the name's first.
std::size_t comment_start(std::string_view line, bool has_name);

/// Returns a name that may have several words, without the comment behind it: with single blanks between the
/// words, and without quotes around them.
std::string name_in(std::string_view text);

/// Returns names of one word each, without the comment behind them; quotes hold words together.
std::vector<std::string> names_in(std::string_view text);

/// Returns a name in UTF-8: one that is not is taken for Latin-1, as older programs write it, so that files
/// and scenes that must be UTF-8 can have it.
std::string utf8_name(const std::string& name);

/// Returns a name as it can stand in a line of an OBJ or MTL file: `_` for line breaks and other control
/// characters, and for a `#` that would begin a comment.
std::string writable_name(std::string name);

}  // namespace sherd
