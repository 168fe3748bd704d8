// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sherd {

/// The words of a line of a text file, in order. Failures throw Error with file and line.
class TextLine {
  public:
    /// number: number of the line, from 1. `file` and `text` must outlive this object and its words.
    TextLine(const std::filesystem::path& file, std::size_t number, std::string_view text)
        : file(&file), number(number), rest(text) {}

    /// Returns the next word; empty at the end of the line.
    std::string_view next_word();
    /// Reads a real number; infinite if it is too large for a double. Throws Error if there is none.
    double next_number();
    bool is_at_end() const;
    std::size_t length() const { return rest.size(); }  ///< bytes behind the last word read
    /// Puts back `end`, the end of the last word that was read, so that it is the next word.
    void put_back(std::string_view end);
    /// Throws Error with the message "file:line: `word` what".
    [[noreturn]] void fail(const std::string& what, std::string_view word) const;

  private:
    const std::filesystem::path* file;
    std::size_t number;
    std::string_view rest;
};

/// Returns `text` without the UTF-8 byte order mark that some editors put in front. Throws Error if it begins
/// with a mark of UTF-16.
std::string_view without_byte_order_mark(const std::filesystem::path& file, std::string_view text);

std::string lower_case(std::string_view word);

/// The lines of a text file, in order. A line ends with LF, CR LF or CR alone.
class TextLines {
  public:
    /// `file` and `text` must outlive the lines.
    TextLines(const std::filesystem::path& file, std::string_view text);

    /// Returns the next line; nullopt at the end of the file.
    std::optional<TextLine> next();
    /// Returns the text of the next line, without its end; empty at the end of the file.
    std::string_view next_text();
    bool is_at_end() const { return rest.empty(); }
    /// Returns the next line that has a word before the first character `comment`, up to that character;
    /// nullopt if there is none. comment: '\0' if the file has no comments.
    std::optional<TextLine> next_with_words(char comment = '\0');
    std::size_t number() const { return count; }         ///< number of the last line returned, from 1
    std::string_view remaining() const { return rest; }  ///< text behind the last line returned

  private:
    const std::filesystem::path* file;
    std::string_view rest;
    bool ends_alone;  ///< whether CR alone ends the first line; if so, LF behind a CR ends another line
    std::size_t count = 0;
};

/// The words of a text file, regardless of its lines.
class TextWords {
  public:
    /// `file` and `text` must outlive the words. comment: as for TextLines::next_with_words().
    TextWords(const std::filesystem::path& file, std::string_view text, char comment = '\0')
        : lines(file, text), line(file, 1, {}), comment(comment) {}

    /// Returns the next word; empty at the end of the file.
    std::string_view next();
    /// Reads a real number as TextLine::next_number() does.
    double next_number();
    bool is_at_end();
    /// Rest of the line of the last word that was read, behind that word.
    TextLine& rest_of_line() { return line; }
    std::size_t number() const { return lines.number(); }  ///< number of the line of the last word, from 1

  private:
    TextLines lines;
    TextLine line;
    char comment;
};

}  // namespace sherd
