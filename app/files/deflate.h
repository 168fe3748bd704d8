// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sherd {

/// How many bytes deflate makes of one at most, those of zeros: PNG and HDF5 compress with it, and a file
/// that promises more is damaged.
inline constexpr std::uintmax_t most_of_a_deflated_byte = 1032;

}  // namespace sherd
