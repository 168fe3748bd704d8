// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sherd {

/// Throws Error (run): there is no room for `bytes` more in a file (0: for more than it has), for the reason
/// that an error number gives.
[[noreturn]] void refuse_room(const std::filesystem::path& file, std::size_t bytes, int reason);

/// Whether an error number says that the disk, a quota or a file size limit is exhausted.
bool disk_is_full(int reason);

}  // namespace sherd
