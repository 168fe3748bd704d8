// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace sherd {

/// Throws Error (run): there is no room for `bytes` more in a file, for the reason that an error number
/// gives.
[[noreturn]] void refuse_room(const std::filesystem::path& file, std::size_t bytes, int reason);

/// Whether an error number says that the disk, a quota or a file size limit is exhausted.
bool disk_is_full(int reason);

/// Space on disk behind the end of a file, so that a full disk is noticed before the file is touched: the
/// destructor gives back what has not been used.
class DiskRoom {
  public:
    /// Throws Error (run) when `bytes` more are not to be had (disk, quota or file size limit).
    DiskRoom(std::filesystem::path file, std::size_t bytes);
    ~DiskRoom();
    DiskRoom(const DiskRoom&) = delete;
    DiskRoom& operator=(const DiskRoom&) = delete;

  private:
    std::filesystem::path file;
};

}  // namespace sherd
