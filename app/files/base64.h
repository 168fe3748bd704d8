// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace sherd {

/// Returns the bytes in the base64 encoding of RFC 4648, padded with `=`.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace sherd
