// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/obj_name.h"

#include <algorithm>

namespace sherd {
namespace {

constexpr std::string_view blanks_of_names = " \t\r\f\v";

/// Takes the first word off the text, with the blanks before it.
std::string_view pop_word(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks_of_names), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(blanks_of_names));
    text.remove_prefix(word.size());
    return word;
}

/// Takes what is between two quotes off the text; empty if it does not begin with a quote or there is no
/// other.
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

}  // namespace

std::size_t comment_start(std::string_view line, bool has_name) {
    if (!has_name) return line.find('#');
    std::string_view rest = line;
    for (std::size_t number = 0;; ++number) {
        const std::string_view word = pop_word(rest);
        if (word.empty()) return line.npos;
        // The first word is the keyword, the second the name's first.
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
