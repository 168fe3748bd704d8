// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// Returns the position in a line of an OBJ or MTL file at which its comment begins; npos: it has none.
/// Without a name in the line, any `#` begins a comment. If the line has a name (`has_name`), a `#` does so
/// only as a word alone, or at the beginning of a word other than the first word of the name.
std::size_t comment_start(std::string_view line, bool has_name);

/// Returns the name in `text`, which may have several words, without a comment behind it, with single blanks
/// between its words, and without quotes around it.
std::string name_in(std::string_view text);

/// Returns the names in `text`, without a comment behind them. Each word is a name; words in quotes are one
/// name together.
std::vector<std::string> names_in(std::string_view text);

/// Returns a name in UTF-8, for files and scenes that must be UTF-8. A name that is not UTF-8 is taken for
/// Latin-1, as older programs write it, and converted.
std::string utf8_name(const std::string& name);

/// Returns `name` in a form that can stand in a line of an OBJ or MTL file: with `_` in place of line breaks
/// and other control characters, and of each `#` that would begin a comment.
std::string writable_name(std::string name);

}  // namespace sherd
