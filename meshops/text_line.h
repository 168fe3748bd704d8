// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sherd {

/// The words of a line of a text file, one after the other. Failures throw Error with file and line.
class TextLine {
  public:
    /// `number`: of the line, 1-based. `file` and `text` have to outlive the words.
    TextLine(const std::filesystem::path& file, std::size_t number, std::string_view text)
        : file(&file), number(number), rest(text) {}

    /// Empty at the end of the line.
    std::string_view next_word();
    /// A real number; one too large for a double is infinite.
    double next_number();
    bool is_at_end() const;
    /// "file:line: `word` what".
    [[noreturn]] void fail(const std::string& what, std::string_view word) const;

  private:
    const std::filesystem::path* file;
    std::size_t number;
    std::string_view rest;
};

/// The lines of a text file, one after the other.
class TextLines {
  public:
    /// `file` and `text` have to outlive the lines.
    TextLines(const std::filesystem::path& file, std::string_view text) : file(&file), rest(text) {}

    /// None at the end of the file.
    std::optional<TextLine> next();
    /// The next one that has a word before a `comment` sign, up to it; '\0': there are no comments.
    std::optional<TextLine> next_with_words(char comment = '\0');
    std::size_t number() const { return count; }         ///< of the line given last, 1-based
    std::string_view remaining() const { return rest; }  ///< behind the line given last

  private:
    std::string_view next_text();

    const std::filesystem::path* file;
    std::string_view rest;
    std::size_t count = 0;
};

}  // namespace sherd
