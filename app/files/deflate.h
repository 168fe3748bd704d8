// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sherd {

/// Largest number of bytes that deflate compresses into one, reached for zeros. PNG and HDF5 use it: a file
/// whose header claims more is damaged.
inline constexpr std::uintmax_t most_of_a_deflated_byte = 1032;

}  // namespace sherd
