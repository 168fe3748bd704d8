// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sherd {

/// Throws Error (run), which says that `file` cannot grow by `bytes` (0: by any amount) and why. reason: an
/// errno value.
[[noreturn]] void throw_no_space(const std::filesystem::path& file, std::size_t bytes, int reason);

/// Whether the errno value `reason` means that the disk, a quota or a file size limit is exhausted.
bool disk_is_full(int reason);

}  // namespace sherd
