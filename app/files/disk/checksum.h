// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace sherd {

/// Returns the 64-bit FNV-1a hash of `text`: texts with equal hashes are equal, unless one of them is forged.
/// sum: hash of a text before `text`; the result is then the hash of both texts together.
constexpr std::uint64_t checksum(std::string_view text, std::uint64_t sum = 14695981039346656037u) {
    for (const char byte : text) sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211u;
    return sum;
}

/// Returns the checksum of a file. Throws Error (input) if it cannot be read.
std::uint64_t checksum_of(const std::filesystem::path& file);

/// Returns the content of a file. Throws Error (input) if it cannot be read.
std::string text_of(const std::filesystem::path& file);

}  // namespace sherd
