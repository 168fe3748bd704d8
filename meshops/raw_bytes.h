// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <string>

namespace sherd {

/// Returns the number whose bytes, in the given order, start at `bytes`.
template <class Number>
Number number_at(const char* bytes, std::endian order) {
    std::array<char, sizeof(Number)> raw;
    std::copy_n(bytes, sizeof(Number), raw.begin());
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
}

/// Appends the bytes of a number in the given byte order.
template <class Number>
void append_number(std::string& bytes, Number number, std::endian order) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

/// Appends the bytes of a number, the lowest first, as the STL format requires and as the headers of our PLY
/// files say.
template <class Number>
void append_little_endian(std::string& bytes, Number number) {
    static_assert(std::endian::native == std::endian::little, "numbers are written as they are in memory");
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

}  // namespace sherd
