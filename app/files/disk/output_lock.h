// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/files/disk/disk_file.h"

namespace sherd {

/// Exclusive lock of an output. A program takes the lock before it deletes or writes anything. The lock is
/// that of flock(2) on the file `OUTPUT.lock` in the same folder, whose text names the program. The kernel
/// releases the lock when the program ends for whatever reason, so that a lock file that is left behind
/// blocks no other program. HDF5's own locks are on the recording itself, and independent of this lock.
///
/// On a file system without flock(2) the existence of `OUTPUT.lock` is the lock.
class OutputLock {
  public:
    /// Takes the lock. Throws Error (input) with the name of the holder if another program, or another object
    /// in this program, holds the lock. Also throws Error (input) if the folder cannot be written, or if
    /// `OUTPUT.lock` exists and is no lock file; Error (run) if the disk is full or locking fails.
    explicit OutputLock(std::filesystem::path output);
    OutputLock(OutputLock&&) = default;
    OutputLock& operator=(OutputLock&&) = delete;
    /// Releases the lock and removes the lock file.
    ~OutputLock();

    const std::filesystem::path& output() const { return target; }

  private:
    bool try_once();

    std::filesystem::path target, file;
    Descriptor held;
};

}  // namespace sherd
