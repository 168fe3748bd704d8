// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/files/disk/disk_file.h"

namespace sherd {

/// Exclusive lock of an output, which a program takes before it deletes or writes anything: a lock (flock) on
/// the file `OUTPUT.lock` in the same folder, which names the program. The kernel releases the lock when the
/// program ends, however it ends; a file that is left then blocks no other program. HDF5's own locks are on
/// the recording itself, and independent of this one.
///
/// On a file system without such locks the existence of the file is the lock.
class OutputLock {
  public:
    /// Throws Error (input) if another program, or another lock of this one, holds the lock, and names it; if
    /// the folder cannot be written; and if `OUTPUT.lock` exists and is no lock file.
    explicit OutputLock(std::filesystem::path output);
    OutputLock(OutputLock&&) = default;
    OutputLock& operator=(OutputLock&&) = delete;
    /// Removes the file.
    ~OutputLock();

    const std::filesystem::path& output() const { return target; }

  private:
    bool try_once();

    std::filesystem::path target, file;
    Descriptor held;
};

}  // namespace sherd
