// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/text_line.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>

#include "meshops/error.h"

namespace sherd {

constexpr std::string_view blanks = " \t\r\f\v";

std::string_view TextLine::next_word() {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

double TextLine::next_number() {
    const std::string_view word = next_word();
    if (word.empty()) fail("a coordinate is missing", {});
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || failure == std::errc::invalid_argument) {
        fail("is not a number", word);
    }
    if (failure != std::errc::result_out_of_range) return value;
    const bool is_tiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return is_tiny ? 0.0 : std::numeric_limits<double>::infinity();
}

bool TextLine::is_at_end() const {
    return rest.find_first_not_of(blanks) == rest.npos;
}

void TextLine::put_back(std::string_view end) {
    rest = {end.data(), end.size() + rest.size()};
}

void TextLine::fail(const std::string& what, std::string_view word) const {
    const std::string quoted = word.empty() ? "" : "`" + std::string(word) + "` ";
    throw Error(file->string() + ":" + std::to_string(number) + ": " + quoted + what);
}

std::string_view without_byte_order_mark(const std::filesystem::path& file, std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw Error(file.string() + ": is text of UTF-16; save it as UTF-8");
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    return text;
}

std::string lower_case(std::string_view word) {
    std::string result(word);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

TextLines::TextLines(const std::filesystem::path& file, std::string_view text) : file(&file), rest(text) {
    const std::size_t end = text.find_first_of("\r\n");
    ends_alone = end != text.npos && text.substr(end, 1) == "\r" && text.substr(end, 2) != "\r\n";
}

std::string_view TextLines::next_text() {
    const std::size_t end = rest.find_first_of("\r\n");
    const std::string_view text = rest.substr(0, end);
    const bool is_pair = !ends_alone && end != rest.npos && rest.substr(end, 2) == "\r\n";
    rest.remove_prefix(end == rest.npos ? rest.size() : end + (is_pair ? 2 : 1));
    ++count;
    return text;
}

std::optional<TextLine> TextLines::next() {
    if (rest.empty()) return std::nullopt;
    const std::string_view text = next_text();
    return TextLine(*file, count, text);
}

std::optional<TextLine> TextLines::next_with_words(char comment) {
    while (!rest.empty()) {
        std::string_view text = next_text();
        if (comment != '\0') text = text.substr(0, text.find(comment));
        if (const TextLine line(*file, count, text); !line.is_at_end()) return line;
    }
    return std::nullopt;
}

bool TextWords::is_at_end() {
    if (!line.is_at_end()) return false;
    const std::optional<TextLine> next = lines.next_with_words(comment);
    if (next) line = *next;
    return !next;
}

std::string_view TextWords::next() {
    return is_at_end() ? std::string_view() : line.next_word();
}

double TextWords::next_number() {
    is_at_end();  // moves to the line of the next word
    return line.next_number();
}

}  // namespace sherd
