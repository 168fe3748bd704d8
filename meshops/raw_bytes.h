// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>

namespace sherd {

/// The number whose bytes start at `bytes`, in the given byte order.
template <class Number>
Number number_at(const char* bytes, std::endian order) {
    std::array<char, sizeof(Number)> raw;
    std::copy_n(bytes, sizeof(Number), raw.begin());
    if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
    return std::bit_cast<Number>(raw);
}

}  // namespace sherd
