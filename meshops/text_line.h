// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sherd {

/// The words of a line of a text file, one after the other. Failures throw Error with file and line.
class TextLine {
  public:
    /// `number`: of the line, 1-based. `text` has to outlive the words.
    TextLine(const std::filesystem::path& file, std::size_t number, std::string_view text)
        : file(file), number(number), rest(text) {}

    /// Empty at the end of the line.
    std::string_view next_word();
    /// A real number; one too large for a double is infinite.
    double next_number();
    bool is_at_end() const;
    /// "file:line: `word` what".
    [[noreturn]] void fail(const std::string& what, std::string_view word) const;

  private:
    const std::filesystem::path& file;
    std::size_t number;
    std::string_view rest;
};

}  // namespace sherd
