// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace sherd {

/// Bytes as text, in the alphabet of RFC 4648, padded.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace sherd
