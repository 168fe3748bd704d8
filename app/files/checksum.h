// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace sherd {

/// FNV-1a, 64 bits: tells whether two texts are the same, unless somebody means to deceive. sum: of what
/// stands before the text.
constexpr std::uint64_t checksum(std::string_view text, std::uint64_t sum = 14695981039346656037u) {
    for (const char byte : text) sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return sum;
}

/// Of a file. Throws Error (input) when it cannot be read.
std::uint64_t checksum_of(const std::filesystem::path& file);

/// All of a file. Throws Error (input) when it cannot be read.
std::string text_of(const std::filesystem::path& file);

}  // namespace sherd
