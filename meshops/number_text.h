// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <string>

namespace sherd {

/// Appends the shortest text of `value` that reads back as exactly the same number.
inline void append(std::string& text, double value) {
    char digits[32];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}
inline void append(std::string& text, std::size_t value) {
    text += std::to_string(value);
}
inline void append(std::string& text, const char* value) {
    text += value;
}

/// Returns a number as text for a message, with four significant digits.
inline std::string number_text(double value) {
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 4).ptr};
}

template <typename... Values>
void append_all(std::string& text, const Values&... values) {
    (append(text, values), ...);
}

}  // namespace sherd
