// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/obj_name.h"

#include <algorithm>
#include <optional>

namespace sherd {
namespace {

constexpr std::string_view blanks_of_names = " \t\r\f\v";

/// Removes the first word of `text`, and the blanks before it. Returns the word.
std::string_view pop_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks_of_names), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks_of_names));
    text.remove_prefix(word.size());
    return word;
}

/// Removes a word in quotes at the start of `text`. Returns it without quotes; returns an empty text, and
/// removes nothing, if there is none.
std::string_view take_quoted(std::string_view& text) {
    std::string_view rest = text;
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks_of_names), rest.size()));
    if (!rest.starts_with('"')) return {};
    const std::size_t end = rest.find('"', 1);
    const bool is_closed =
        end != rest.npos &&
        (end + 1 == rest.size() || blanks_of_names.find(rest[end + 1]) != std::string_view::npos);
    if (!is_closed) return {};
    text = rest.substr(end + 1);
    return rest.substr(1, end - 1);
}

/// Number of bytes that follow the first byte of a character in UTF-8; nullopt if no character begins with
/// `first`.
std::optional<std::size_t> bytes_behind(unsigned char first) {
    if (first < 0x80) return 0;
    if (first >= 0xc2 && first < 0xe0) return 1;
    if (first >= 0xe0 && first < 0xf0) return 2;
    if (first >= 0xf0 && first < 0xf5) return 3;
    return std::nullopt;
}

bool is_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto more = bytes_behind(static_cast<unsigned char>(text[i]));
        if (!more || i + *more >= text.size()) return false;
        const auto first = static_cast<unsigned char>(text[i]);
        const auto second = static_cast<unsigned char>(text[i + (*more > 0 ? 1 : 0)]);
        // Overlong forms, surrogates of UTF-16 and code points beyond the last one are invalid.
        if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
            (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
            return false;
        for (std::size_t end = i + *more; i < end;)
            if ((static_cast<unsigned char>(text[++i]) & 0xc0) != 0x80) return false;
    }
    return true;
}

}  // namespace

std::string utf8_name(const std::string& name) {
    if (is_utf8(name)) return name;
    std::string result;
    for (const char letter : name) {
        const auto byte = static_cast<unsigned char>(letter);
        if (byte < 0x80) {
            result += letter;
        } else {
            result += static_cast<char>(0xc0 | byte >> 6);
            result += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return result;
}

std::size_t comment_start(std::string_view line, bool has_name) {
    if (!has_name) return line.find('#');
    std::string_view rest = line;
    for (std::size_t number = 0;; ++number) {
        const std::string_view word = pop_word(rest);
        if (word.empty()) return line.npos;
        // Word 0 is the keyword, and word 1 the first word of the name.
        if (word.starts_with('#') && (number != 1 || word.size() == 1))
            return static_cast<std::size_t>(word.data() - line.data());
    }
}

std::string name_in(std::string_view text) {
    if (const std::string_view quoted = take_quoted(text); !quoted.empty()) return std::string(quoted);
    std::string name;
    for (auto word = pop_word(text); !word.empty(); word = pop_word(text)) {
        if (word.starts_with('#') && (!name.empty() || word.size() == 1)) break;
        name += (name.empty() ? "" : " ") + std::string(word);
    }
    return name;
}

std::vector<std::string> names_in(std::string_view text) {
    std::vector<std::string> names;
    while (true) {
        std::string_view word = take_quoted(text);
        if (word.empty()) {
            word = pop_word(text);
            if (word.starts_with('#') && (!names.empty() || word.size() == 1)) return names;
        }
        if (word.empty()) return names;
        names.emplace_back(word);
    }
}

std::string writable_name(std::string name) {
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto sign = static_cast<unsigned char>(name[i]);
        const bool begins_comment = sign == '#' && (i == 0 || name[i - 1] == ' ');
        if (sign < ' ' || sign == 0x7f || begins_comment) name[i] = '_';
    }
    return name;
}

}  // namespace sherd
