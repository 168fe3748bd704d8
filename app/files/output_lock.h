// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/files/descriptor.h"

namespace sherd {

/// The right to write an output, which one program has at a time, from before it deletes or writes anything:
/// a lock (flock) on the file `OUTPUT.lock` in the same folder, in which it says who it is. The kernel takes
/// the lock back when the program ends, however it ends; a file that is left then blocks nobody. HDF5's own
/// locks are on the recording itself and know nothing of this one.
///
/// Where a file system has no such locks the file alone is the lock.
class OutputLock {
  public:
    /// Throws Error (input) when another program, or another lock of this one, has it, saying which; when the
    /// folder cannot be written; and when `OUTPUT.lock` is there and is somebody's file.
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
