// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// Returns `text` in lines of at most `width` characters where words allow it, those after the first
/// indented.
std::string wrapped(std::string text, std::size_t width, std::size_t indent);

/// Number of columns of the terminal on stdout; 0 if stdout is none.
std::size_t terminal_columns();

}  // namespace sherd
