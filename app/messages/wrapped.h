// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// Returns `text` with line breaks at blanks, so that lines have at most `width` characters, not counting the
/// indentation. All lines but the first are indented by `indent` blanks. After the first word that is longer
/// than `width` the text is not broken any more.
std::string wrapped(std::string text, std::size_t width, std::size_t indent);

/// Returns the number of columns of the terminal on stdout; 0 if stdout is not a terminal.
std::size_t terminal_columns();

}  // namespace sherd
